// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/noise/regional_field.h>
#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** The layers in which the points of a cloud lie whose coordinates come in steps, as depth cameras give them: within
  * one, neighbourhoods show no noise however large it is. */
struct LayerEstimate
{
  /** How often the number of points must be halved until the eight nearest lie in more than one layer. Without regions:
    * there are no layers, or neighbourhoods as they are see past them. */
  RegionalField halvings;
  /** From one layer to the next, in the unit of the positions. */
  RegionalField steps;
  /** Sigma over the step. */
  float noise_of_step = 0;
  /** A depth camera at the origin saw them: the steps are along its rays. */
  bool are_of_camera = false;

  bool
  hasLayers () const
  {
    return !halvings.regions.empty ();
  }
};

/** Looks at a sample of about 4,096 points.
  *
  * Layers are told from flat parts of a clean surface, plates and stairs by this: most of the points whose eight
  * nearest lie exactly in a plane do so in parallel planes, and among the nearest 32, of all points or of a thinner
  * cloud, those off the plane lie in one more plane above or below, and to one side.
  * \param[in] graph its rows have at least eight points; else nothing is found */
LayerEstimate
estimateLayers (const NeighborGraph& graph, const Positions& nodes, const Execution& execution);
} // namespace core
} // namespace pcl_normal_smoothing
