# SPDX-License-Identifier: BSD-3-Clause
"""Meshes and clouds as arrays, and the two measures that colour the renderings."""

import numpy
import scipy.spatial
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkImplicitPolyDataDistance
from vtkmodules.vtkIOPLY import vtkPLYReader


class Unreadable(Exception):
    """A file has unexpected content; the text says which."""


def read_ply(path):
    """The polygon data of a PLY file with at least one point."""
    reader = vtkPLYReader()
    reader.SetFileName(path)
    reader.Update()
    data = reader.GetOutput()
    if data.GetNumberOfPoints() == 0:
        raise Unreadable(f"{path} holds no points")
    return data


def points_of(data):
    """The points, n x 3."""
    return vtk_to_numpy(data.GetPoints().GetData()).astype(float)


def normals_of(data):
    """The normals, n x 3, or None."""
    normals = data.GetPointData().GetNormals()
    return vtk_to_numpy(normals).astype(float) if normals else None


def triangles_of(data):
    """The triangles' indices, m x 3; faces with more corners are left out."""
    cells = data.GetPolys()
    offsets = vtk_to_numpy(cells.GetOffsetsArray())
    corners = vtk_to_numpy(cells.GetConnectivityArray())
    starts = offsets[:-1][numpy.diff(offsets) == 3]
    return corners[starts[:, None] + numpy.arange(3)]


def surface(points, triangles):
    """A triangle mesh as polygon data."""
    data = vtkPolyData()
    holder = vtkPoints()
    holder.SetData(numpy_to_vtk(numpy.ascontiguousarray(points, dtype=numpy.float32), deep=True))
    data.SetPoints(holder)
    cells = vtkCellArray()
    offsets = numpy.arange(0, 3 * len(triangles) + 1, 3)
    corners = numpy.ascontiguousarray(triangles, dtype=numpy.int64).ravel()
    cells.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True), numpy_to_vtkIdTypeArray(corners, deep=True))
    data.SetPolys(cells)
    return data


def mean_edge(points, triangles):
    """Mean length of the triangles' edges; shared ones count once."""
    sides = numpy.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    sides = numpy.unique(numpy.sort(sides, axis=1), axis=0)
    return float(numpy.linalg.norm(points[sides[:, 0]] - points[sides[:, 1]], axis=1).mean())


def distances(points, mesh):
    """Distance of each point to the polygon data."""
    distance = vtkImplicitPolyDataDistance()
    distance.SetInput(mesh)
    values = numpy_to_vtk(numpy.zeros(len(points)), deep=True)
    distance.FunctionValue(numpy_to_vtk(numpy.ascontiguousarray(points), deep=True), values)
    return numpy.abs(vtk_to_numpy(values))


def surface_variation(points, k=15):
    """Smallest eigenvalue over the sum of all, for the covariance of the k nearest points, the point itself included."""
    _, neighbours = scipy.spatial.cKDTree(points).query(points, k=min(k, len(points)))
    offsets = points[neighbours] - points[neighbours].mean(axis=1, keepdims=True)
    eigenvalues = numpy.linalg.eigvalsh(numpy.einsum("nki,nkj->nij", offsets, offsets))
    return numpy.maximum(eigenvalues[:, 0], 0) / numpy.maximum(eigenvalues.sum(axis=1), 1e-300)


def spacings(points, place):
    """Distance of each point to its \a place-th nearest other point."""
    lengths, _ = scipy.spatial.cKDTree(points).query(points, k=place + 1)
    return lengths[:, -1]


def write_ply(path, points, normals):
    """Writes a binary PLY with normals, which the tools can read."""
    names = "x y z normal_x normal_y normal_z".split()
    header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(points)}"]
    header += [f"property float {name}" for name in names] + ["end_header", ""]
    with open(path, "wb") as file:
        file.write("\n".join(header).encode())
        file.write(numpy.hstack([points, normals]).astype("<f4").tobytes())
