// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/neighbor_graph.h>

#include <array>

namespace pcl_normal_smoothing
{
namespace core
{
/** Length of the rows that are looked at, or of the whole cloud where that has fewer points. */
constexpr std::uint32_t noise_row_length = 16;

/** What the sample of a cloud tells of its noise. The samples of its parts make that of the whole, in any order. */
struct NoiseSample
{
  /** What quadrics leave about one point. */
  struct Residuals
  {
    /** Variances, through the 8, 12 and 16 nearest points, or all where there are fewer; NaN where these are fewer than seven or
      * all in one place. */
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

  /** Leaves out nodes whose eight nearest lie in one plane exactly: in a layer they tell nothing. \return their number */
  std::size_t
  dropPlanes ();
};

/** Nodes of a cloud, or of a part of it, that are in a sample of about \a sample_size: those with the smallest hashes of their
  * coordinates, so that a smaller sample is part of a larger one.
  * \param[in] cloud_size finite points of the whole cloud */
std::vector<std::uint32_t>
sampleNodes (const Positions& nodes, std::uint64_t cloud_size, std::size_t sample_size, const Execution& execution);

/** Those in the sample of the noise, about 4,096. */
std::vector<std::uint32_t>
noiseSampleNodes (const Positions& nodes, std::uint64_t cloud_size);

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
