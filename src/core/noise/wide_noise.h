// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/noise/noise_field.h>
#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** sigma over the spacing: below it, quadrics through 32 points follow as much of the surface as of the noise. */
constexpr float least_ratio_to_project = .75f;

/** Noise so much wider than the spacing that small neighbourhoods are balls inside it, and show neither the surface
  * nor the extent of the noise: all over the cloud, in clumps of points, or in a part of it. */
struct WideNoise
{
  /** Its usual standard deviation, as shown by much thinner clouds, in the unit of the positions; 0 if no wide noise
    * is seen. */
  float sigma = 0;
  /** How it varies. */
  NoiseField field;
  /** Factor on sigma where neighbourhoods grow, so that no noise is taken for surface: most_excess if stronger
    * smoothing loses no detail, else least_excess. */
  float excess = most_excess;
  static constexpr float least_excess = 1.2f, most_excess = 1.5f;
  /** Number of halvings of the cloud after which neighbourhoods show the surface, in regions of a sample of about
    * 4,096 points. */
  RegionalField halvings;
  /** Ratio of sigma to the spacing, likewise, if such neighbourhoods would lose detail: points are then projected
    * first (core/noise/quadric_projection.h), and neighbourhoods stay as they are. No regions otherwise. */
  RegionalField ratios;
  /** False: only in a part of the cloud; sigma and its field are those of the whole cloud, and \a halvings are below
    * 0 elsewhere. */
  bool is_everywhere = true;
};

/** \param[in] graph with rows of at least 16 points; otherwise nothing is found */
WideNoise
estimateWideNoise (const NeighborGraph& graph, const Positions& nodes, const Execution& execution);
} // namespace core
} // namespace pcl_normal_smoothing
