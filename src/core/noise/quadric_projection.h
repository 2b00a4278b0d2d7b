// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/noise/regional_field.h>
#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** Where noise is wider than the spacing: moves every node onto a quadric through the nearest of all nodes, 32 to 128
  * of them, the more the larger the noise; again and again, until what is left is hardly wider than the spacing.
  * Neighbourhoods that are searched afterwards show the surface.
  * \param[in] ratios of the noise's sigma to the spacing, by regions, at least one; nodes stay where it is below .75
  * \param[in,out] nodes those of \a graph, whose rows do not matter; their offsets change */
void
projectOntoQuadrics (const NeighborGraph& graph,
                     const RegionalField& ratios,
                     const Execution& execution,
                     Positions& nodes);
} // namespace core
} // namespace pcl_normal_smoothing
