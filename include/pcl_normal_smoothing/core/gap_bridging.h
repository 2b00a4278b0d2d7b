// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/layer_estimate.h>
#include <pcl_normal_smoothing/core/line_estimate.h>
#include <pcl_normal_smoothing/core/wide_noise.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** Gaps between the layers of a depth camera or the lines of a scanner, which neighbourhoods as they are searched do not reach across. */
struct GapEstimate
{
  LayerEstimate layers;
  /** See estimateLines; where there are layers, none are looked for. */
  RegionalField lines;
  /** See estimateWideNoise; where there are layers or lines, none is looked for. */
  RegionalField wide_noise;

  bool
  hasGaps () const
  {
    return !halvings ().regions.empty ();
  }

  /** How often the number of points must be halved until neighbourhoods reach across. */
  const RegionalField&
  halvings () const
  {
    return layers.hasLayers () ? layers.halvings : lines.regions.empty () ? wide_noise : lines;
  }
};

/** Looks at a sample of about 4,096 points.
  * \param[in] graph as for estimateLayers and estimateLines */
GapEstimate
estimateGaps (const NeighborGraph& graph, const Positions& nodes, const Execution& execution);

/** Gives every node as many neighbours as it has, but so far apart that most lie across a gap.
  * \return null where rows stay as they are: there are no gaps, or the rows differ in length, for whoever bounds neighbourhoods
  * by a radius means it */
NeighborGraph::Ptr
bridgeGaps (const NeighborGraph& graph, const Positions& nodes, const GapEstimate& gaps, const Execution& execution);
} // namespace core
} // namespace pcl_normal_smoothing
