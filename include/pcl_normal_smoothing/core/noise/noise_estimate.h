// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/noise/noise_field.h>
#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** What hides noise from small neighbourhoods, so that it is read from wider ones. */
enum class NoiseHiddenBy
{
  NOTHING,
  LAYERS,   //!< coordinates come in steps, as those of a depth camera
  LINES,    //!< points lie on lines, as those of a lidar or a profiler
  ROUNDING, //!< coordinates are rounded, to voxels or few digits
  WIDTH     //!< the noise is wider than the points are apart, everywhere or in places
};

/** What a cloud tells of its noise, in the unit of its positions. */
struct NoiseEstimate
{
  /** Standard deviation of the noise along the normal: at half of the points it is larger, where it varies. */
  float sigma = 0;
  /** Distance between neighbouring points: the median over the points. */
  float spacing = 0;
  /** How sigma varies over the cloud. */
  NoiseField field = {};
  NoiseHiddenBy hidden_by = NoiseHiddenBy::NOTHING;

  /** The same in the cloud's unit: see Positions::unit. */
  NoiseEstimate
  inCloudUnit (double unit) const
  {
    return {static_cast<float> (sigma * unit), static_cast<float> (spacing * unit), field.inUnit (1 / unit), hidden_by};
  }
};

/** Estimates the noise from what quadrics through small neighbourhoods leave, and extrapolates from two sizes of
  * neighbourhood what curvature adds to it. Uses a sample of about 4,096 points that is chosen by a hash of the
  * coordinates, and quantiles, which do not depend on an order: the same cloud gives the same bits in any order. Where
  * points lie in layers or on lines, or noise is wide, wider neighbourhoods tell it.
  * \param[in] graph where a row has fewer than 16 points, the neighbours are searched again
  * \return sigma 0 where neighbourhoods have fewer than 8 points or no extent */
NoiseEstimate
estimateNoise (const NeighborGraph& graph, const Positions& nodes, const Execution& execution);
} // namespace core
} // namespace pcl_normal_smoothing
