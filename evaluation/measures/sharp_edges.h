// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "meshes/mesh_io.h"

namespace pcl_normal_smoothing::evaluation
{

/** The vertices within \a reach of an edge at which the surface turns by more than \a degrees. Edges of only one
  * triangle, or of more than two, do not count as sharp. */
std::vector<std::uint32_t>
verticesNearSharpEdges (const tools::Mesh& mesh, double degrees, double reach);

} // namespace pcl_normal_smoothing::evaluation
