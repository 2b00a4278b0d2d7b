// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh_io.h"

namespace pcl_normal_smoothing
{
namespace tools
{
/** Mean length of the edges, each counted once however many triangles share it. */
double
meanEdgeLength (const Mesh& mesh);

double
area (const Mesh& mesh);

/** Area-weighted normals of the vertices, of length 1; zero for a vertex whose triangles have no area. */
std::vector<Eigen::Vector3d>
vertexNormals (const Mesh& mesh);
} // namespace tools
} // namespace pcl_normal_smoothing
