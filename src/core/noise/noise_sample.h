// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

#include <array>

namespace pcl_normal_smoothing
{
namespace core
{
/** Places of which the sample of the noise is. */
constexpr std::size_t noise_sample_size = 4096;

/** Length of the rows that are looked at, or of the whole cloud where that has fewer points. */
constexpr std::uint32_t noise_row_length = 16;

/** What the sample of a cloud tells of its noise. The samples of its parts make that of the whole, in any order. */
struct NoiseSample
{
  /** What quadrics leave about one point. */
  struct Residuals
  {
    /** Variances, through the 8, 12 and 16 nearest points, or all where there are fewer, as where some of the 16 are
      * copies of others but for rounding; NaN where these are fewer than seven or all in one place. */
    std::array<float, 3> variances;
    /** Of the eighth; 0 where there are fewer. */
    float distance;
    Eigen::Vector3f place;
  };

  std::vector<Residuals> of_nodes;
  /** Nodes that do not count: their rows have fewer than noise_row_length points, though the cloud has as many. */
  std::size_t short_rows = 0;

  void
  join (const NoiseSample& part);

  /** Leaves out nodes whose eight nearest lie in one plane exactly: in a layer they tell nothing. \return their
    * number */
  std::size_t
  dropPlanes ();
};

/** That of a whole cloud.
  * \param[in] graph where a row is shorter than noise_row_length, the neighbours are searched again */
NoiseSample
sampleNoise (const NeighborGraph& graph, const Positions& nodes, const Execution& execution);

/** That of a part of a cloud.
  * \param[in] cloud_size finite points of the whole cloud */
NoiseSample
sampleNoise (const NeighborGraph& graph,
             const Positions& nodes,
             const std::vector<std::uint32_t>& sample,
             std::uint64_t cloud_size,
             const Execution& execution);
} // namespace core
} // namespace pcl_normal_smoothing
