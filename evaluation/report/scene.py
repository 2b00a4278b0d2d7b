# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of surfaces and points by VTK, all taken with one kind of camera."""

import numpy
import vtkmodules.vtkInteractionStyle  # noqa: F401 (registers)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 (registers)
from matplotlib import colormaps
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

PLAIN = (0.83, 0.84, 0.86)
# Positions of the lights relative to the camera (right, up, back), and their intensities.
FRONT = (((-0.35, 0.5, 1), 0.8), ((0.9, -0.1, 0.5), 0.35))
RAKING = (((-1, 0.7, 0.3), 0.8), ((0.2, 0, 1), 0.25))


class View:
    """A parallel camera: viewing direction, up, centre, and half the width and height of the visible part."""

    def __init__(self, points, looking, up, margin=1.04):
        self.looking = numpy.asarray(looking) / numpy.linalg.norm(looking)
        self.right = numpy.cross(self.looking, up)
        self.right /= numpy.linalg.norm(self.right)
        self.up = numpy.cross(self.right, self.looking)
        across, upward = points @ self.right, points @ self.up
        depth = points @ self.looking
        middle = [(values.min() + values.max()) / 2 for values in (across, upward, depth)]
        self.centre = middle[0] * self.right + middle[1] * self.up + middle[2] * self.looking
        self.half_width = max(numpy.ptp(across), 1e-12) / 2 * margin
        self.half_height = max(numpy.ptp(upward), 1e-12) / 2 * margin
        self.depth = max(numpy.ptp(depth), self.half_height, 1e-12)

    def aspect(self):
        """Width over height, clamped to what fits on a page."""
        return min(max(self.half_width / self.half_height, 0.6), 2.2)


def view_of(points, triangles):
    """A view from somewhat above, with y upward, as most meshes stand. Of several around the shape, chooses the one that shows
    a broad side and varied slopes, since a flat back shows little."""
    corners = points[triangles]
    faces = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    areas = numpy.maximum(numpy.linalg.norm(faces, axis=1), 1e-300)
    views = []
    for height in numpy.radians([18, 45]):
        for turn in numpy.radians([25, -25, 65, -65, 115, -115, 155, -155]):
            away = numpy.array([numpy.sin(turn) * numpy.cos(height), numpy.sin(height), numpy.cos(turn) * numpy.cos(height)])
            view = View(points, -away, (0, 1, 0))
            facing = numpy.maximum(faces @ away, 0)
            flatness = (facing**2 / areas).sum() / max(facing.sum(), 1e-300)
            views.append((view.half_width * view.half_height * (1.4 - flatness), len(views), view))
    return max(views)[2]


class Stage:
    """One off-screen window; draw() returns pictures as arrays. Close it while its display still exists."""

    def __init__(self, height=560):
        self.height = height
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(8)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.window.Finalize()

    def draw(self, actors, view, lights=FRONT):
        """An array, height x width x 3, with a white background."""
        renderer = vtkRenderer()
        renderer.SetBackground(1, 1, 1)
        renderer.AutomaticLightCreationOff()
        for place, strength in lights:
            light = vtkLight()
            light.SetLightTypeToCameraLight()
            light.SetPosition(*place)
            light.SetFocalPoint(0, 0, 0)
            light.SetIntensity(strength)
            renderer.AddLight(light)
        for actor in actors:
            renderer.AddActor(actor)
        self._aim(renderer, view)
        self.window.AddRenderer(renderer)
        self.window.SetSize(int(self.height * view.aspect()), self.height)
        self.window.Render()
        image = self._grab()
        self.window.RemoveRenderer(renderer)
        return image

    def _aim(self, renderer, view):
        camera = renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetFocalPoint(*view.centre)
        camera.SetPosition(*(view.centre - 4 * view.depth * view.looking))
        camera.SetViewUp(*view.up)
        camera.SetParallelScale(max(view.half_height, view.half_width / view.aspect()))
        renderer.ResetCameraClippingRange()

    def _grab(self):
        grabber = vtkWindowToImageFilter()
        grabber.SetInput(self.window)
        grabber.ReadFrontBufferOff()
        grabber.Update()
        image = grabber.GetOutput()
        width, height, _ = image.GetDimensions()
        return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[::-1, :, :3].copy()


def coloured(data, values=None, limits=(0, 1), colours="viridis", flat=True):
    """An actor for polygon data, plain or coloured by one value per point."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOff()
    if values is not None:
        scalars = numpy_to_vtk(numpy.ascontiguousarray(values, dtype=numpy.float32), deep=True)
        data.GetPointData().SetScalars(scalars)
        mapper.ScalarVisibilityOn()
        mapper.SetLookupTable(_table(colours, limits))
        mapper.UseLookupTableScalarRangeOn()
        mapper.InterpolateScalarsBeforeMappingOn()
    actor = vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetColor(*PLAIN)
    look.SetAmbient(0.2 if values is None else 0.34)
    look.SetDiffuse(0.85 if values is None else 0.6)
    look.SetSpecular(0.05)
    if flat:
        look.SetInterpolationToFlat()
    return actor


def _table(colours, limits):
    table = vtkLookupTable()
    table.SetNumberOfTableValues(256)
    table.SetRange(*limits)
    for index, colour in enumerate(colormaps[colours](numpy.linspace(0, 1, 256))):
        table.SetTableValue(index, *colour)
    table.Build()
    return table
