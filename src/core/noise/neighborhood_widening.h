// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "coordinate_rounding.h"
#include "layer_estimate.h"
#include "line_estimate.h"
#include "wide_noise.h"
#include <pcl_normal_smoothing/core/noise/noise_estimate.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** Why neighbourhoods as searched do not show the surface, and how much wider they have to be: points lie in layers
  * or on lines, or the noise is wider than the spacing. */
struct Widening
{
  LayerEstimate layers;
  /** See estimateLines; not sought if there are layers. */
  LineEstimate lines;
  /** See estimateWideNoise; not sought if there are layers or lines. */
  WideNoise wide_noise;
  /** Hides noise too, but does not call for wider neighbourhoods. */
  CoordinateRounding rounding;

  /** Everything that does not call for wider neighbourhoods. */
  Widening
  roundingAlone () const
  {
    return {{}, {}, {}, rounding};
  }

  bool
  isNeeded () const
  {
    return !halvings ().regions.empty ();
  }

  /** Whether neighbourhoods stay as they are, and points are to be projected: see WideNoise::ratios. */
  bool
  projects () const
  {
    return !wide_noise.ratios.regions.empty ();
  }

  /** The first that applies; rounding before layers that are its own. */
  NoiseHiddenBy
  hiddenBy () const;

  /** Number of halvings of the cloud after which neighbourhoods in what is left show the surface. */
  const RegionalField&
  halvings () const
  {
    return layers.hasLayers () ? layers.halvings : lines.hasLines () ? lines.halvings : wide_noise.halvings;
  }
};

/** Uses a sample of about 4,096 points. If rows differ in length, only the rounding of coordinates is estimated.
  * \param[in] graph as for estimateLayers, estimateLines and estimateWideNoise */
Widening
estimateWidening (const NeighborGraph& graph, const Positions& nodes, const Execution& execution);

/** Replaces the neighbours of every node by as many that are farther away.
  * \return null if rows stay as they are: they show the surface, or points are to be projected, or rows differ in
  * length, as when the user bounds neighbourhoods by a radius */
NeighborGraph::Ptr
widenNeighborhoods (const NeighborGraph& graph,
                    const Positions& nodes,
                    const Widening& widening,
                    const Execution& execution);

/** Projects the nodes if only that shows the surface, and searches neighbourhoods of the same length again.
  * \param[in,out] nodes their offsets change
  * \return null if they stay */
NeighborGraph::Ptr
projectNodes (const NeighborGraph& graph, const Widening& widening, const Execution& execution, Positions& nodes);
} // namespace core
} // namespace pcl_normal_smoothing
