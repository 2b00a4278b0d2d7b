// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud_graph.h"

#include <pcl_normal_smoothing/core/chain/local_surface.h>

namespace pcl_normal_smoothing
{
namespace tools
{
/** Writes normals and surface variations to the fields normal_x normal_y normal_z curvature, which are added if
  * missing. Normals are turned towards the sensor's origin, as by pcl::NormalEstimation. A point without a surface gets
  * NaN.
  * \param[in] surfaces one per node of \a graph
  * \throw core::Error if no node has a surface, or an existing field has an unsuitable type */
void
writeSurfaces (const core::NeighborGraph& graph, const std::vector<core::LocalSurface>& surfaces, CloudFile& file);

/** Reads the normals of the cloud, one per node of \a graph. \throw core::Error if no node has one */
core::Vectors
loadNormals (const core::NeighborGraph& graph, const VectorLayout& normals, const CloudFile& file);
} // namespace tools
} // namespace pcl_normal_smoothing
