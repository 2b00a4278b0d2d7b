// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

#include <vector>

namespace pcl_normal_smoothing
{
namespace core
{
/** How coordinates were rounded, all three: to the centres of voxels, or to few digits. */
struct CoordinateRounding
{
  /** In the unit of the positions; 0: none is found. */
  float step = 0;
  /** Flat parts a step apart are seen, as rounding makes them of a surface, and hardly anything else does. */
  bool is_seen = false;

  /** What rounding makes of sigma.
    * \param[in] sigma as it is read from the neighbourhoods */
  float
  atLeast (float sigma) const;
};

/** The step in which coordinates come.
  * \param[in] places a sample of the cloud, hundreds
  * \return in the unit of the places, the smallest of the three axes; 0 where one of them has no step, as depth images
  * have and heights over a grid, or where all lie in one place */
double
coordinateStep (const std::vector<Eigen::Vector3d>& places);

/** \param[in] graph of all nodes, at least one */
CoordinateRounding
estimateRounding (const NeighborGraph& graph, const Positions& nodes, const Execution& execution);
} // namespace core
} // namespace pcl_normal_smoothing
