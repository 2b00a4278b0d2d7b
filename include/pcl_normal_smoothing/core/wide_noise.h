// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/neighbor_graph.h>
#include <pcl_normal_smoothing/core/regional_field.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** Noise so much wider than the spacing, everywhere or where points lie in clumps, that small neighbourhoods are balls inside it, which
  * show neither the surface nor how far the noise goes. */
struct WideNoise
{
  /** How often the number of points must be halved until neighbourhoods show both, by regions of about 4,096 points of a sample. Without
    * regions: neighbourhoods as they are show them, or none does. */
  RegionalField halvings;
  /** Its usual standard deviation, as much thinner clouds show it, in the unit of the positions. */
  float sigma = 0;
};

/** \param[in] graph its rows have at least 16 points; else nothing is found */
WideNoise
estimateWideNoise (const NeighborGraph& graph, const Positions& nodes, const Execution& execution);
} // namespace core
} // namespace pcl_normal_smoothing
