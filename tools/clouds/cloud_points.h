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

/** The points of a cloud that stand for the vertices of a mesh.
  * \throw core::Error where their numbers differ, or a point is not finite */
Points
verticesOf (const CloudFile& file, const Mesh& mesh);

/** The points of a cloud that are finite, in their order.
  * \throw core::Error where there are none */
Points
finitePointsOf (const CloudFile& file);

/** The normals of a cloud, zero where one is not finite; nothing where it has no fields of normals. */
std::optional<Points>
normalsOf (const CloudFile& file);
} // namespace tools
} // namespace pcl_normal_smoothing
