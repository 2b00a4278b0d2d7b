// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/surface_actor.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>

#include <algorithm>
#include <numeric>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
vtkSmartPointer<vtkCellArray>
trianglesForVtk (const std::vector<Mesh::Triangle>& triangles)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New ();
  for (const auto& [a, b, c] : triangles)
    cells->InsertNextCell ({static_cast<vtkIdType> (a), static_cast<vtkIdType> (b), static_cast<vtkIdType> (c)});
  return cells;
}

/** One cell that holds all points. */
vtkSmartPointer<vtkCellArray>
pointsForVtk (std::size_t count)
{
  std::vector<vtkIdType> numbers (count);
  std::iota (numbers.begin (), numbers.end (), 0);
  auto cells = vtkSmartPointer<vtkCellArray>::New ();
  cells->InsertNextCell (static_cast<vtkIdType> (count), numbers.data ());
  return cells;
}

vtkSmartPointer<vtkFloatArray>
arrayForVtk (std::size_t count, int components)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New ();
  array->SetNumberOfComponents (components);
  array->SetNumberOfTuples (static_cast<vtkIdType> (count));
  return array;
}
} // namespace

SurfaceActor::SurfaceActor (const Eigen::Vector3d& origin,
                            const std::vector<Mesh::Triangle>& triangles,
                            const vtkSmartPointer<vtkLookupTable>& colours)
: origin_ (origin)
, triangles_ (triangles.empty () ? nullptr : trianglesForVtk (triangles))
, data_ (vtkSmartPointer<vtkPolyData>::New ())
, mapper_ (vtkSmartPointer<vtkPolyDataMapper>::New ())
, actor_ (vtkSmartPointer<vtkActor>::New ())
{
  mapper_->SetInputData (data_);
  mapper_->SetLookupTable (colours);
  mapper_->InterpolateScalarsBeforeMappingOn ();
  actor_->SetMapper (mapper_);
  vtkProperty* look = actor_->GetProperty ();
  look->SetAmbient (0.2);
  look->SetDiffuse (0.8);
  look->SetSpecular (0);
  // The sign of a normal means nothing: every point is lit as if it faced the viewer.
  actor_->GetShaderProperty ()->AddFragmentShaderReplacement (
      "//VTK::Normal::Impl", true,
      "//VTK::Normal::Impl\n  if (normalVCVSOutput.z < 0.0) normalVCVSOutput = -normalVCVSOutput;\n", false);
  drawTriangles (triangles_ != nullptr);
}

void
SurfaceActor::set (const Surface& surface, const std::vector<float>& values, double limit)
{
  const std::size_t count = surface.nodes.size ();
  auto positions = arrayForVtk (count, 3), normals = arrayForVtk (count, 3), scalars = arrayForVtk (count, 1);
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3f position = (surface.position (i) - origin_).cast<float> ();
    const Eigen::Vector3f& normal = surface.normals[i];
    const Eigen::Vector3f lit = normal.allFinite () ? normal : Eigen::Vector3f (0, 0, 1);
    positions->SetTypedTuple (static_cast<vtkIdType> (i), position.data ());
    normals->SetTypedTuple (static_cast<vtkIdType> (i), lit.data ());
    scalars->SetValue (static_cast<vtkIdType> (i), values[i]);
  }
  data_->SetPoints (vtkSmartPointer<vtkPoints>::New ());
  data_->GetPoints ()->SetData (positions);
  data_->GetPointData ()->SetNormals (normals);
  data_->GetPointData ()->SetScalars (scalars);
  data_->Modified ();
  mapper_->SetScalarRange (0, limit);
  drawTriangles (as_triangles_);
}

void
SurfaceActor::drawTriangles (bool triangles)
{
  as_triangles_ = triangles && triangles_;
  const auto points = data_->GetNumberOfPoints ();
  if (as_triangles_) {
    data_->SetPolys (triangles_);
    data_->SetVerts (nullptr);
    actor_->GetProperty ()->SetInterpolationToFlat (); // facets show noise, interpolation would hide it
  }
  else {
    data_->SetPolys (nullptr);
    data_->SetVerts (pointsForVtk (static_cast<std::size_t> (points)));
    actor_->GetProperty ()->SetInterpolationToPhong ();
  }
}

void
SurfaceActor::setPointSize (double size)
{
  actor_->GetProperty ()->SetPointSize (static_cast<float> (size));
}

} // namespace tools
} // namespace pcl_normal_smoothing
