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
/** Why neighbourhoods as they are searched do not show the surface, and how much wider they have to be: points lie in
  * layers, on lines, or the noise is wider than they are apart. */
struct Widening
{
  LayerEstimate layers;
  /** See estimateLines; where there are layers, none are looked for. */
  LineEstimate lines;
  /** See estimateWideNoise; where there are layers or lines, none is looked for. */
  WideNoise wide_noise;
  /** Hides noise likewise, but calls for no wider neighbourhoods. */
  CoordinateRounding rounding;

  /** Nothing that calls for wider neighbourhoods. */
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

  /** Neighbourhoods stay as they are, but points are to be projected: see WideNoise::ratios. */
  bool
  projects () const
  {
    return !wide_noise.ratios.regions.empty ();
  }

  /** The first that applies; rounding before layers that are its own. */
  NoiseHiddenBy
  hiddenBy () const;

  /** How often the number of points must be halved until neighbourhoods in what is left show the surface. */
  const RegionalField&
  halvings () const
  {
    return layers.hasLayers () ? layers.halvings : lines.hasLines () ? lines.halvings : wide_noise.halvings;
  }
};

/** Looks at a sample of about 4,096 points. Where rows differ in length, for the rounding of coordinates alone.
  * \param[in] graph as for estimateLayers, estimateLines and estimateWideNoise */
Widening
estimateWidening (const NeighborGraph& graph, const Positions& nodes, const Execution& execution);

/** Gives every node as many neighbours as it has, but farther away.
  * \return null where rows stay as they are: they show the surface, or points are to be projected, or rows differ in
  * length, for whoever bounds neighbourhoods by a radius means it */
NeighborGraph::Ptr
widenNeighborhoods (const NeighborGraph& graph,
                    const Positions& nodes,
                    const Widening& widening,
                    const Execution& execution);

/** Projects the nodes where that is what shows the surface, and searches neighbourhoods of the same length again.
  * \param[in,out] nodes their offsets change
  * \return null where they stay */
NeighborGraph::Ptr
projectNodes (const NeighborGraph& graph, const Widening& widening, const Execution& execution, Positions& nodes);
} // namespace core
} // namespace pcl_normal_smoothing
