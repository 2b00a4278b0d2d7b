// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/neighbor_graph.h>
#include <pcl_normal_smoothing/core/regional_field.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** Noise so much wider than the spacing, everywhere or where points lie in clumps, that small neighbourhoods are balls inside it, which
  * show neither the surface nor how far the noise goes.
  * \param[in] graph its rows have at least 16 points; else nothing is found
  * \return how often the number of points must be halved until they show both, by regions of about 4,096 points of a sample. Without
  * regions: neighbourhoods as they are show them, or none does */
RegionalField
estimateWideNoise (const NeighborGraph& graph, const Positions& nodes, const Execution& execution);
} // namespace core
} // namespace pcl_normal_smoothing
