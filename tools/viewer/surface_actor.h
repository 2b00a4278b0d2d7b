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
/** A surface in VTK: as points, which are lit by their normals whichever side is viewed, or as triangles.
  *
  * PCLVisualizer::addPointCloud is not used: it draws points without lighting, so that noise cannot be seen, and in
  * float, so that clouds at UTM coordinates lose their shape. */
class SurfaceActor
{
public:
  /** \param[in] origin subtracted from positions \param[in] triangles between nodes; may be empty */
  SurfaceActor (const Eigen::Vector3d& origin,
                const std::vector<Mesh::Triangle>& triangles,
                const vtkSmartPointer<vtkLookupTable>& colours);

  /** \param[in] values one per node \param[in] limit end of the colour scale */
  void
  set (const Surface& surface, const std::vector<float>& values, double limit);

  /** Draws triangles, if wanted and there are any, otherwise points. */
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
