// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/noise/regional_field.h>
#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** The layers formed by points whose coordinates come in steps, as from depth cameras: a neighbourhood within one
  * layer shows no noise, however large it is. */
struct LayerEstimate
{
  /** Number of halvings of the cloud after which the eight nearest lie in more than one layer. No regions: there are
    * no layers, or neighbourhoods as they are see past them. */
  RegionalField halvings;
  /** Distance between neighbouring layers, in the unit of the positions. */
  RegionalField steps;
  /** Sigma over the step. */
  float noise_of_step = 0;
  /** Whether the layers are from a depth camera at the origin, with steps along its rays. */
  bool are_of_camera = false;

  bool
  hasLayers () const
  {
    return !halvings.regions.empty ();
  }
};

/** Uses a sample of about 4,096 points.
  *
  * Layers are distinguished from flat parts of a clean surface, plates and stairs: an eighth of the points whose
  * eight nearest lie exactly in a plane do so in parallel planes; and among the 32 nearest, in the whole cloud or a
  * thinner one, those off the plane lie in one more plane above or below, and to one side. Of a camera at the origin it
  * suffices that nearly all that is flat is parallel, and has planes a step above and below.
  * \param[in] graph with rows of at least eight points; otherwise nothing is found */
LayerEstimate
estimateLayers (const NeighborGraph& graph, const Positions& nodes, const Execution& execution);
} // namespace core
} // namespace pcl_normal_smoothing
