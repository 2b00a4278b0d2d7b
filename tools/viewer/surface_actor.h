// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "viewer/session.h"

#include <vtkActor.h>
#include <vtkLookupTable.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkSmartPointer.h>

namespace pcl_normal_smoothing
{
namespace tools
{
/** A surface in VTK: as points, lit by their normals from whatever side one looks, or as triangles.
  *
  * Not by PCLVisualizer::addPointCloud, which draws points without light, where noise cannot be seen, and in float,
  * where clouds at UTM coordinates lose their shape. */
class SurfaceActor
{
public:
  /** \param[in] origin moved to zero \param[in] triangles between nodes; may be none */
  SurfaceActor (const Eigen::Vector3d& origin,
                const std::vector<Mesh::Triangle>& triangles,
                const vtkSmartPointer<vtkLookupTable>& colours);

  /** \param[in] values a number for every node \param[in] limit of the colours */
  void
  set (const Surface& surface, const std::vector<float>& values, double limit);

  /** Draws triangles, where there are some, or points. */
  void
  drawTriangles (bool triangles);

  /** In pixels. */
  void
  setPointSize (double size);

  vtkActor*
  actor () const
  {
    return actor_;
  }

private:
  Eigen::Vector3d origin_;
  vtkSmartPointer<vtkCellArray> triangles_;
  vtkSmartPointer<vtkPolyData> data_;
  vtkSmartPointer<vtkPolyDataMapper> mapper_;
  vtkSmartPointer<vtkActor> actor_;
  bool as_triangles_ = false;
};

} // namespace tools
} // namespace pcl_normal_smoothing
