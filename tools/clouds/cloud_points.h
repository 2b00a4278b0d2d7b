// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "files/cloud_io.h"
#include "meshes/mesh_io.h"

#include <optional>

namespace pcl_normal_smoothing
{
namespace tools
{
using Points = std::vector<Eigen::Vector3d>;

/** The points of a cloud in which point i is vertex i of a mesh.
  * \throw core::Error if their numbers differ, or a point is not finite */
Points
verticesOf (const CloudFile& file, const Mesh& mesh);

/** The finite points of a cloud, in their order.
  * \throw core::Error if there are none */
Points
finitePointsOf (const CloudFile& file);

/** The normals of a cloud, with zero for those that are not finite; empty if it has no fields of normals. */
std::optional<Points>
normalsOf (const CloudFile& file);
} // namespace tools
} // namespace pcl_normal_smoothing
