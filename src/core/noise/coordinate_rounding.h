// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

#include <vector>

namespace pcl_normal_smoothing
{
namespace core
{
/** Rounding of all three coordinates: to voxel centres, or to few digits. */
struct CoordinateRounding
{
  /** In the unit of the positions; 0 if none is found. */
  float step = 0;
  /** Whether flat parts one step apart are seen, which hardly anything but rounding produces. */
  bool is_seen = false;

  /** Raises sigma to what rounding causes, if the cloud shows any noise.
    * \param[in] sigma as estimated from the neighbourhoods */
  float
  atLeast (float sigma) const;
};

/** The step of the coordinates.
  * \param[in] places a sample of the cloud, hundreds
  * \return the smallest step of the three axes, in the unit of the places; 0 if an axis has no step, as in depth
  * images and heights over a grid, or if all lie in one place */
double
coordinateStep (const std::vector<Eigen::Vector3d>& places);

/** \param[in] graph of all nodes, at least one */
CoordinateRounding
estimateRounding (const NeighborGraph& graph, const Positions& nodes, const Execution& execution);
} // namespace core
} // namespace pcl_normal_smoothing
