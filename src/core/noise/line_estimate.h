// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/noise/regional_field.h>
#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** The lines of a scanner that takes points much closer along them than across, as a lidar that turns: neighbourhoods
  * of one line do not show the surface, and no noise, for the line and its noise lie in one plane or cone.
  * \param[in] graph its rows have at least eight points; else nothing is found
  * \return how often the number of points must be halved until the eight nearest lie on more than one line, by regions
  * of about 4,096 points of a sample. Without regions: there are no lines */
RegionalField
estimateLines (const NeighborGraph& graph, const Positions& nodes, const Execution& execution);
} // namespace core
} // namespace pcl_normal_smoothing
