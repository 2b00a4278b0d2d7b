# SPDX-License-Identifier: BSD-3-Clause
"""The paper's Fig. 9: a real scan with its raw noise, smoothed by the paper's choice and by our default."""

import os
import tempfile

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkFiltersCore import vtkGlyph3D
from vtkmodules.vtkFiltersSources import vtkDiskSource
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkCommonTransforms import vtkTransform

import geometry
from panels import Panel, save
from running import ToolTrouble, run
from scene import RAKING, View, coloured

WHOLE = 20000  # larger scans are cropped, or their noise could not be seen
CASES = (("raw scan", None), ("paper: PGU7, 5 and 7 iterations", "paper"), ("ours: default", "default"))


def add(page, folder, stage, tools, scan):
    page.heading("Fig. 9: a real scan")
    if not scan:
        page.gap("Fig. 9", "no scan was given: evaluation/study.sh -scan file.pcd")
        return
    try:
        with tempfile.TemporaryDirectory() as work:
            clouds = [(title, *_cloud(scan, preset, tools, work)) for title, preset in CASES]
    except (ToolTrouble, geometry.Unreadable) as error:
        page.gap("Fig. 9", str(error))
        return
    raw = clouds[0][1]
    view, radii = scan_view(raw, clouds[0][2]), 0.62 * geometry.spacings(raw, 4)
    panels = [Panel(title, stage.draw([_discs(points, normals, radii)], view, RAKING)) for title, points, normals in clouds]
    image = save(panels, folder, "fig9", columns=3, width=3.7, aspect=view.aspect())
    part = " (a part of it is shown)" if len(raw) > WHOLE else ""
    page.figure(
        image,
        (
            f"Fig. 9: {os.path.basename(scan)}, {len(raw)} points, as it came from the scanner{part}; no truth is known."
            " Each point is a disc across its normal (WPCA, k 9, on the cloud shown)."
        ),
    )


def _cloud(scan, preset, tools, work):
    """The finite points, the same ones before and after smoothing, and their normals."""
    smoothed, shown = scan, os.path.join(work, "shown.ply")
    if preset:
        smoothed = os.path.join(work, "smoothed.ply")
        run(tools, "pcl_normal_smoothing", scan, smoothed, "-preset", preset)
    run(tools, "pcl_wpca_normal_estimation", smoothed, shown, "-k", 9)
    data = geometry.read_ply(shown)
    points, normals = geometry.points_of(data), geometry.normals_of(data)
    finite = numpy.isfinite(points).all(axis=1)
    if finite.sum() < 10:
        raise geometry.Unreadable(f"{scan} holds fewer than 10 finite points")
    return points[finite], numpy.nan_to_num(normals[finite], nan=0.57735)


def scan_view(points, normals):
    """From the depth camera's position if all points lie in front of it (z forward, y down), otherwise along -z with y up. The
    frame leaves out the outermost thousandth on each side; of a large scan it shows the ninth with the most varied slopes."""
    if len(points) <= WHOLE:
        low, high = numpy.percentile(points[:, :2], [0.1, 99.9], axis=0)
        inner = _within(points, low, high)
    else:
        edges = numpy.percentile(points[:, :2], [4, 35, 65, 96], axis=0)
        windows = [
            _within(points, (edges[i, 0], edges[j, 1]), (edges[i + 1, 0], edges[j + 1, 1]))
            for i in range(3)
            for j in range(3)
        ]
        inner = max(windows, key=lambda window: _unlikeness(normals[window]))
    inner = points[inner] if inner.any() else points
    if (points[:, 2] > 0).all():
        return View(inner, (0, 0, 1), (0, -1, 0), margin=1.1)
    return View(inner, (0, -0.1, -1), (0, 1, 0), margin=1.1)


def _within(points, low, high):
    return ((points[:, :2] >= low) & (points[:, :2] <= high)).all(axis=1)


def _unlikeness(normals):
    """How much the normals differ, whatever their signs: 0 if all are parallel; grows with their number."""
    return len(normals) - numpy.linalg.eigvalsh(normals.T @ normals)[-1] if len(normals) else 0


def _discs(points, normals, radii):
    data = geometry.surface(points, numpy.zeros((0, 3), int))
    data.GetPointData().SetNormals(numpy_to_vtk(numpy.ascontiguousarray(normals, dtype=numpy.float32), deep=True))
    data.GetPointData().SetScalars(numpy_to_vtk(numpy.minimum(radii, 4 * numpy.median(radii)), deep=True))
    glyphs = vtkGlyph3D()
    glyphs.SetInputData(data)
    glyphs.SetSourceData(_disc())
    glyphs.SetVectorModeToUseNormal()
    glyphs.SetScaleModeToScaleByScalar()
    glyphs.Update()
    return coloured(glyphs.GetOutput())


def _disc():
    """A disc of radius 1, perpendicular to x, as glyphs align x with the normal."""
    disc = vtkDiskSource()
    disc.SetInnerRadius(0)
    disc.SetOuterRadius(1)
    disc.SetCircumferentialResolution(8)
    turn = vtkTransform()
    turn.RotateY(90)
    turned = vtkTransformPolyDataFilter()
    turned.SetInputConnection(disc.GetOutputPort())
    turned.SetTransform(turn)
    turned.Update()
    return turned.GetOutput()
