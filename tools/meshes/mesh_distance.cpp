// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_distance.h"

#include <vtkCellArray.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStaticCellLocator.h>

#include <cmath>

namespace pcl_normal_smoothing
{
namespace tools
{
struct MeshDistance::Locator
{
  Eigen::Vector3d origin; // subtracted from the mesh: VTK's tolerances grow with the size of the coordinates
  vtkNew<vtkPolyData> mesh;
  vtkNew<vtkStaticCellLocator> cells;
};

MeshDistance::MeshDistance (const Mesh& mesh) : locator_ (std::make_unique<Locator> ())
{
  locator_->origin = mesh.vertices.front ();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble ();
  for (const Eigen::Vector3d& vertex : mesh.vertices)
    points->InsertNextPoint (Eigen::Vector3d (vertex - locator_->origin).data ());
  vtkNew<vtkCellArray> cells;
  for (const Mesh::Triangle& t : mesh.triangles)
    cells->InsertNextCell (
        {static_cast<vtkIdType> (t[0]), static_cast<vtkIdType> (t[1]), static_cast<vtkIdType> (t[2])});
  locator_->mesh->SetPoints (points);
  locator_->mesh->SetPolys (cells);
  locator_->cells->SetDataSet (locator_->mesh);
  locator_->cells->BuildLocator ();
}

MeshDistance::~MeshDistance () = default;

double
MeshDistance::of (const Eigen::Vector3d& point) const
{
  static thread_local vtkNew<vtkGenericCell> cell;
  double closest[3], squared = 0;
  vtkIdType cell_id;
  int sub_id;
  locator_->cells->FindClosestPoint (Eigen::Vector3d (point - locator_->origin).data (), closest, cell, cell_id, sub_id,
                                     squared);
  return std::sqrt (squared);
}
} // namespace tools
} // namespace pcl_normal_smoothing
