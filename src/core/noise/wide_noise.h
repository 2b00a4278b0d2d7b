// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/noise/noise_field.h>
#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** sigma over the spacing: where it is smaller, a quadric through 32 points follows as much of the surface as of the
  * noise. */
constexpr float least_ratio_to_project = .75f;

/** Noise so much wider than the spacing that small neighbourhoods are balls inside it, which show neither the surface
  * nor how far the noise goes: in all of the cloud, in clumps of points, or in a part of it. */
struct WideNoise
{
  /** Its usual standard deviation, as much thinner clouds show it, in the unit of the positions; 0: no wide noise is
    * seen. */
  float sigma = 0;
  /** How it varies. */
  NoiseField field;
  /** Factor on sigma where neighbourhoods grow, so that no noise is taken for surface: most_excess where stronger
    * smoothing loses no detail, else least_excess. */
  float excess = most_excess;
  static constexpr float least_excess = 1.2f, most_excess = 1.5f;
  /** How often the number of points must be halved until neighbourhoods show the surface, by regions of about 4,096
    * points of a sample. */
  RegionalField halvings;
  /** The ratio of sigma to the spacing, likewise, where such neighbourhoods would lose detail: points had better be
    * projected first (core/noise/quadric_projection.h), and neighbourhoods stay as they are. Else without regions. */
  RegionalField ratios;
  /** False: only in a part of the cloud; sigma and its field are those of all of it, and \a halvings are 0
    * elsewhere. */
  bool is_everywhere = true;
};

/** \param[in] graph its rows have at least 16 points; else nothing is found */
WideNoise
estimateWideNoise (const NeighborGraph& graph, const Positions& nodes, const Execution& execution);
} // namespace core
} // namespace pcl_normal_smoothing
