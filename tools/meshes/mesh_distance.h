// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh_io.h"

#include <memory>

namespace pcl_normal_smoothing
{
namespace tools
{
/** Distances of points to a mesh, by VTK's cell locator. */
class MeshDistance
{
public:
  /** \param[in] mesh with at least one triangle */
  explicit MeshDistance (const Mesh& mesh);

  ~MeshDistance ();

  /** Distance of a point, in the mesh's unit. May be called from several threads at once. */
  double
  of (const Eigen::Vector3d& point) const;

private:
  struct Locator;
  std::unique_ptr<Locator> locator_;
};
} // namespace tools
} // namespace pcl_normal_smoothing
