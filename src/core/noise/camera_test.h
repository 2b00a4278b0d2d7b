// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** From the origin to the middle of the points as they are seen from there, of length 1; zero where they do not all lie
  * before it, less than 53 degrees aside. */
Eigen::Vector3d
viewingDirection (const Positions& nodes, const Execution& execution);

/** Whether the points are those of a depth camera at the origin: seen from there, neighbours lie a pixel apart, near or
  * far.
  * \param[in] graph of all nodes
  * \param[in] axis of the camera, of length 1, to either side */
bool
isGridOfCamera (const NeighborGraph& graph,
                const Positions& nodes,
                const Eigen::Vector3d& axis,
                const Execution& execution);
} // namespace core
} // namespace pcl_normal_smoothing
