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

/** Estimated noise of a cloud, in the unit of its positions. */
struct NoiseEstimate
{
  /** Standard deviation of the noise along the normal; if it varies, the median over the points. */
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

/** Estimates the noise from the residuals of quadrics through small neighbourhoods, and from two sizes of these
  * extrapolates the part that is due to curvature. Uses a sample of about 4,096 points, chosen by a hash of the
  * coordinates, and quantiles, which do not depend on an order: for the same cloud the result is bit for bit the same
  * in any order. If points lie in layers or on lines, or noise is wide, it uses wider neighbourhoods.
  * \param[in] graph if a row has fewer than 16 points, the neighbours are searched again
  * \return sigma 0 if neighbourhoods have fewer than 8 points or no extent */
NoiseEstimate
estimateNoise (const NeighborGraph& graph, const Positions& nodes, const Execution& execution);
} // namespace core
} // namespace pcl_normal_smoothing
