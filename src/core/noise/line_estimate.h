// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/noise/regional_field.h>
#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

#include <limits>

namespace pcl_normal_smoothing
{
namespace core
{
/** The lines of a scanner that takes points much closer along them than across, as a lidar that turns: neighbourhoods
  * of one line do not show the surface, and quadrics no noise, for the line and its noise lie in one plane or cone. */
struct LineEstimate
{
  /** How often the number of points must be halved until the eight nearest lie on more than one line, by regions. Without
    * regions: there are no lines. */
  RegionalField halvings;
  /** What is more than this is no noise but detail between the lines, in the unit of the positions. */
  float most_sigma = std::numeric_limits<float>::infinity ();

  bool
  hasLines () const
  {
    return !halvings.regions.empty ();
  }
};

/** Looks at a sample of about 4,096 points.
  * \param[in] graph its rows have at least eight points; else nothing is found */
LineEstimate
estimateLines (const NeighborGraph& graph, const Positions& nodes, const Execution& execution);
} // namespace core
} // namespace pcl_normal_smoothing
