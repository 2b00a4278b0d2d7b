// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud_graph.h"

#include <pcl_normal_smoothing/core/chain/local_surface.h>

namespace pcl_normal_smoothing
{
namespace tools
{
/** Writes normals and surface variations to the fields normal_x normal_y normal_z curvature, which are added where they
  * are missing. Normals point to the sensor's origin, as those of pcl::NormalEstimation do. A point without a surface
  * gets NaN.
  * \param[in] surfaces one a node of \a graph
  * \throw core::Error where none has one */
void
writeSurfaces (const core::NeighborGraph& graph, const std::vector<core::LocalSurface>& surfaces, CloudFile& file);

/** The normals of the cloud's fields, by the nodes of \a graph. \throw core::Error where no node has one */
core::Vectors
loadNormals (const core::NeighborGraph& graph, const VectorLayout& normals, const CloudFile& file);
} // namespace tools
} // namespace pcl_normal_smoothing
