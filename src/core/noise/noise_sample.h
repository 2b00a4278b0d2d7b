// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

#include <array>

namespace pcl_normal_smoothing
{
namespace core
{
/** Number of places in the sample of the noise. */
constexpr std::size_t noise_sample_size = 4096;

/** Length of the rows that are used; the whole cloud if it has fewer points. */
constexpr std::uint32_t noise_row_length = 16;

/** What a sample shows of the noise of a cloud. The samples of its parts, joined in any order, make that of the
  * whole. */
struct NoiseSample
{
  /** Residuals of quadrics around one point. */
  struct Residuals
  {
    /** Variances for the 8, 12 and 16 nearest points, or for all if there are fewer, as when some of the 16 are
      * copies up to rounding; NaN if fewer than seven are left or all lie in one place. */
    std::array<float, 3> variances;
    /** Distance of the eighth nearest; 0 if there are fewer. */
    float distance;
    Eigen::Vector3f place;
  };

  std::vector<Residuals> of_nodes;
  /** Nodes that do not count: their rows have fewer than noise_row_length points, unlike the cloud. */
  std::size_t short_rows = 0;

  void
  join (const NoiseSample& part);

  /** Removes nodes whose eight nearest lie exactly in one plane: within a layer they show nothing. \return their
    * number */
  std::size_t
  dropPlanes ();
};

/** The sample of a whole cloud.
  * \param[in] graph if a row is shorter than noise_row_length, neighbours are searched again */
NoiseSample
sampleNoise (const NeighborGraph& graph, const Positions& nodes, const Execution& execution);

/** The sample of a part of a cloud.
  * \param[in] cloud_size number of finite points in the whole cloud */
NoiseSample
sampleNoise (const NeighborGraph& graph,
             const Positions& nodes,
             const std::vector<std::uint32_t>& sample,
             std::uint64_t cloud_size,
             const Execution& execution);
} // namespace core
} // namespace pcl_normal_smoothing
