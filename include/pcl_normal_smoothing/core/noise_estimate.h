// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/neighbor_graph.h>

#include <array>

namespace pcl_normal_smoothing
{
namespace core
{
/** What a cloud tells of its noise, in the unit of its positions. */
struct NoiseEstimate
{
  /** Standard deviation of the noise along the normal. */
  float sigma = 0;
  /** Distance between neighbouring points: the median over the points. */
  float spacing = 0;

  /** The same in the cloud's unit: see Positions::unit. */
  NoiseEstimate
  inCloudUnit (double unit) const
  {
    return {static_cast<float> (sigma * unit), static_cast<float> (spacing * unit)};
  }
};

/** Estimates the noise from what quadrics through small neighbourhoods leave, and extrapolates from two sizes of
  * neighbourhood what curvature adds to it. Uses a sample of about 4,096 points that is chosen by a hash of the coordinates,
  * and quantiles, which do not depend on an order: the same cloud gives the same bits in any order.
  * \param[in] graph where a row has fewer than 16 points, the neighbours are searched again
  * \return sigma 0 where neighbourhoods have fewer than 8 points or no extent */
NoiseEstimate
estimateNoise (const NeighborGraph& graph, const Positions& nodes, const Execution& execution);

/** Length of the rows that estimateNoise looks at, or of the whole cloud where that has fewer points. */
constexpr std::uint32_t noise_row_length = 16;

/** What the sample of a cloud tells of its noise. The samples of its parts make that of the whole, in any order. */
struct NoiseSample
{
  /** What quadrics leave about one point. */
  struct Residuals
  {
    /** Variances, through the 8, 12 and 16 nearest points; NaN where there are fewer. */
    std::array<float, 3> variances;
    /** Of the eighth; 0 where there are fewer. */
    float distance;
  };

  std::vector<Residuals> of_nodes;
  /** Nodes that do not count: their rows have fewer than noise_row_length points, though the cloud has as many. */
  std::size_t short_rows = 0;

  void
  join (const NoiseSample& part);
};

/** Nodes of a cloud, or of a part of it, that are in a sample of about \a sample_size: those with the smallest hashes of their
  * coordinates, so that a smaller sample is part of a larger one.
  * \param[in] cloud_size finite points of the whole cloud */
std::vector<std::uint32_t>
sampleNodes (const Positions& nodes, std::uint64_t cloud_size, std::size_t sample_size, const Execution& execution);

/** Those in the sample that the noise is estimated from. */
std::vector<std::uint32_t>
noiseSampleNodes (const Positions& nodes, std::uint64_t cloud_size);

/** \param[in] cloud_size finite points of the whole cloud */
NoiseSample
sampleNoise (const NeighborGraph& graph,
             const Positions& nodes,
             const std::vector<std::uint32_t>& sample,
             std::uint64_t cloud_size,
             const Execution& execution);

/** The estimate from the sample of the whole cloud; nothing where most of its rows are short. */
NoiseEstimate
estimateNoise (const NoiseSample& sample);
} // namespace core
} // namespace pcl_normal_smoothing
