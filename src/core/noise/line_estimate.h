// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/noise/regional_field.h>
#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

#include <limits>

namespace pcl_normal_smoothing
{
namespace core
{
/** Lines of a scanner whose points are much closer along them than across, such as a rotating lidar: a neighbourhood
  * on one line does not show the surface, and quadrics show no noise, as the line and its noise lie in one plane or
  * cone. */
struct LineEstimate
{
  /** Number of halvings of the cloud after which the eight nearest lie on more than one line, by regions. No
    * regions: there are no lines. */
  RegionalField halvings;
  /** Upper bound on sigma: anything above is detail between the lines. In the unit of the positions. */
  float most_sigma = std::numeric_limits<float>::infinity ();

  bool
  hasLines () const
  {
    return !halvings.regions.empty ();
  }
};

/** Uses a sample of about 4,096 points.
  * \param[in] graph with rows of at least eight points; otherwise nothing is found */
LineEstimate
estimateLines (const NeighborGraph& graph, const Positions& nodes, const Execution& execution);
} // namespace core
} // namespace pcl_normal_smoothing
