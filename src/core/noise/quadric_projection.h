// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/noise/regional_field.h>
#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** For noise wider than the spacing: moves every node onto a quadric through its nearest among all nodes, 32 to 128 of
  * them, more for larger noise; repeatedly, until what is left is hardly wider than the spacing. Neighbourhoods
  * searched afterwards show the surface.
  * \param[in] ratios of sigma to the spacing, in at least one region; nodes stay where the ratio is below .75
  * \param[in,out] nodes those of \a graph, whose rows are not used; their offsets change */
void
projectOntoQuadrics (const NeighborGraph& graph,
                     const RegionalField& ratios,
                     const Execution& execution,
                     Positions& nodes);
} // namespace core
} // namespace pcl_normal_smoothing
