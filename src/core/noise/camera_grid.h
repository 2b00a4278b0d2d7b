// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** Unit vector from the origin to the middle of the points as seen from there; zero unless nearly all (99 %) lie
  * before it, less than 53 degrees off. */
Eigen::Vector3d
viewingDirection (const Positions& nodes, const Execution& execution);

/** Whether the points are those of a depth camera at the origin: seen from there, neighbours are one pixel apart, near
  * and far.
  * \param[in] graph of all nodes
  * \param[in] axis of the camera, of unit length; its sign does not matter */
bool
isGridOfCamera (const NeighborGraph& graph,
                const Positions& nodes,
                const Eigen::Vector3d& axis,
                const Execution& execution);
} // namespace core
} // namespace pcl_normal_smoothing
