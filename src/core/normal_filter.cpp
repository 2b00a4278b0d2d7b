// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/error.h>
#include <pcl_normal_smoothing/core/exponential.h>
#include <pcl_normal_smoothing/core/normal_filter.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
/** s n_j: the neighbour's normal turned to the side of n_i. \a cosine becomes n_i.s n_j. */
Eigen::Vector3f
turned (const Eigen::Vector3f& normal, bool oriented, float& cosine)
{
  if (oriented || cosine > 0)
    return normal;
  cosine = -cosine;
  return -normal;
}

/** T of eq. 7 for one neighbourhood. */
float
mixedThreshold (std::uint32_t node,
                NeighborGraph::Row row,
                const Vectors& normals,
                const NormalFilterOptions& options)
{
  float sum = 0;
  for (const std::uint32_t j : row) {
    float cosine = normals[node].dot (normals[j]);
    turned (normals[j], options.oriented, cosine);
    if (!std::isnan (cosine))
      sum += (1 - cosine) * (1 - cosine);
  }
  const auto k = static_cast<float> (row.size ());
  return options.mixed_threshold == MixedThreshold::PRINTED ? std::sqrt (sum) / k : std::sqrt (sum / k);
}

float
square (float x)
{
  return x * x;
}
} // namespace

void
check (const NormalFilterOptions& options)
{
  if (options.iterations < 0)
    throw Error ("the number of normal iterations is " + std::to_string (options.iterations) + ": give 0 or more");
  if (!(options.threshold >= 0 && options.threshold < 1))
    throw Error ("the threshold T of eq. 3 is " + std::to_string (options.threshold) +
                 ": give a cosine of at least 0 and below 1");
  if (!(options.sigma_s > 0))
    throw Error ("sigma_s of the normal filter is " + std::to_string (options.sigma_s) + ": give a number above 0");
}

Eigen::Vector3f
filteredNormal (std::uint32_t node,
                NeighborGraph::Row row,
                const Positions& positions,
                const Vectors& normals,
                float inverse_two_sigma_c_squared,
                const NormalFilterOptions& options)
{
  const Eigen::Vector3f& n_i = normals[node];
  const bool mixed = options.weight == NormalWeight::MIXED;
  const float mixed_threshold = mixed ? mixedThreshold (node, row, normals, options) : 0;
  const float inverse_two_sigma_s_squared = 1 / (2 * options.sigma_s * options.sigma_s);
  Eigen::Vector3f sum (0, 0, 0);
  for (const std::uint32_t j : row) {
    float cosine = n_i.dot (normals[j]);
    if (std::isnan (cosine))
      continue;
    const Eigen::Vector3f n_j = turned (normals[j], options.oriented, cosine);
    float weight = 0;
    if (options.weight == NormalWeight::THRESHOLD)
      weight = cosine <= options.threshold ? 0 : square (cosine - options.threshold); // eq. 3
    else {
      const float sq_dist = positions.difference (node, j).squaredNorm ();
      const float x = 1 - cosine; // (n_i - s n_j).n_i of unit normals; |n_i - s n_j|^2 is twice this
      if (mixed)                  // eqs. 6 and 7
        weight = x >= mixed_threshold
                     ? 0
                     : gaussian (sq_dist, inverse_two_sigma_c_squared) * square (x - mixed_threshold);
      else // eqs. 4 and 5, the two Gaussians in one exponential
        weight = expOfMinus (sq_dist * inverse_two_sigma_c_squared +
                             std::max (2 * x, 0.0f) * inverse_two_sigma_s_squared);
    }
    sum += weight * n_j; // eq. 2
  }
  const float length = sum.norm ();
  return length > 0 ? Eigen::Vector3f (sum / length) : n_i;
}

float
inverseTwoSigmaCSquared (std::uint32_t node, NeighborGraph::Row row, const Positions& positions)
{
  float sum = 0;
  for (const std::uint32_t j : row)
    sum += positions.difference (node, j).norm ();
  if (!(sum > 0))
    return 0;
  const float sigma_c = sum / static_cast<float> (row.size () - 1);
  return 1 / (2 * sigma_c * sigma_c);
}

void
filterNormals (const NeighborGraph& graph,
               const Positions& positions,
               const NormalFilterOptions& options,
               const Execution& execution,
               Vectors& normals)
{
  if (options.iterations == 0)
    return;
  std::vector<float> inverse_two_sigma_c_squared (graph.size ());
  Vectors next (graph.size ());
  for (int iteration = 0; iteration < options.iterations; ++iteration) {
    const double share = 1.0 / options.iterations;
    parallelFor (graph.size (), execution.part (iteration * share, (iteration + 1) * share),
                 [&] (std::size_t begin, std::size_t end) {
                   for (auto i = static_cast<std::uint32_t> (begin); i < end; ++i) {
                     if (iteration == 0)
                       inverse_two_sigma_c_squared[i] = inverseTwoSigmaCSquared (i, graph.row (i), positions);
                     next[i] = filteredNormal (i, graph.row (i), positions, normals,
                                               inverse_two_sigma_c_squared[i], options);
                   }
                 });
    normals.swap (next);
  }
}
} // namespace core
} // namespace pcl_normal_smoothing
