// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/error.h>
#include <pcl_normal_smoothing/core/exponential.h>
#include <pcl_normal_smoothing/core/point_update.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
/** 1 / (2 sigma_c^2) of eq. 9, sigma_c the distance of the farthest neighbour now; 0 where that is 0. */
float
inverseTwoSigmaCSquared (std::uint32_t node, NeighborGraph::Row row, const Positions& positions)
{
  float farthest = 0;
  for (const std::uint32_t j : row)
    farthest = std::max (farthest, positions.difference (node, j).squaredNorm ());
  return farthest > 0 ? 1 / (2 * farthest) : 0;
}

/** \a step, shortened so that the node stays within \a radius of where it began. */
Eigen::Vector3f
capped (const Eigen::Vector3f& displacement, float radius)
{
  const float length = displacement.norm ();
  return length > radius ? Eigen::Vector3f (displacement * (radius / length)) : displacement;
}
} // namespace

void
check (const PointUpdateOptions& options)
{
  if (options.iterations < 0)
    throw Error ("the number of point iterations is " + std::to_string (options.iterations) + ": give 0 or more");
  if (!(options.sigma_s > 0))
    throw Error ("sigma_s of the point update is " + std::to_string (options.sigma_s) + ": give a number above 0");
  if (!(options.max_displacement > 0))
    throw Error ("the maximal displacement is " + std::to_string (options.max_displacement) +
                 ": give a length above 0");
  if (options.search_interval < 0)
    throw Error ("the search interval is " + std::to_string (options.search_interval) + ": give 0 or more");
}

Vectors
displacements (const Vectors& start, const Positions& nodes)
{
  Vectors result (start.size ());
  for (std::size_t i = 0; i < start.size (); ++i)
    result[i] = nodes.offset[i] - start[i];
  return result;
}

Eigen::Vector3f
updateStep (std::uint32_t node,
            NeighborGraph::Row row,
            const Positions& positions,
            const Vectors& normals,
            const PointUpdateOptions& options)
{
  const Eigen::Vector3f& n_i = normals[node];
  const float distance_factor = inverseTwoSigmaCSquared (node, row, positions);
  const float normal_factor = 1 / (2 * options.sigma_s * options.sigma_s);
  Eigen::Vector3f sum (0, 0, 0);
  float weights = 0;
  for (const std::uint32_t j : row) {
    const Eigen::Vector3f& n_j = normals[j];
    const float signed_cosine = n_i.dot (n_j);
    if (std::isnan (signed_cosine))
      continue;
    const bool flip = !options.oriented && signed_cosine <= 0;
    const float x = 1 - (options.oriented ? signed_cosine : std::abs (signed_cosine));
    const Eigen::Vector3f difference = positions.difference (node, j);
    // Eq. 9, the two Gaussians in one exponential.
    const float weight = expOfMinus (difference.squaredNorm () * distance_factor + x * x * normal_factor);
    // Eq. 8, in which the signs of both n_j cancel; or along the mean of both normals.
    const Eigen::Vector3f turned = flip ? Eigen::Vector3f (-n_j) : n_j;
    const float height = options.rule == UpdateRule::PAPER ? turned.dot (difference)
                                                           : 0.5f * (n_i + turned).dot (difference);
    sum += (weight * height) * turned;
    weights += weight;
  }
  return weights > 0 ? Eigen::Vector3f (sum / weights) : Eigen::Vector3f (0, 0, 0);
}

void
updatePoints (NeighborGraph::ConstPtr graph,
              const Vectors& normals,
              const PointUpdateOptions& options,
              const Research& research,
              const Execution& execution,
              Positions& positions)
{
  if (options.iterations == 0)
    return;
  const Vectors start = positions.offset;
  Vectors next (graph->size ());
  for (int iteration = 0; iteration < options.iterations; ++iteration) {
    if (options.search_interval > 0 && iteration > 0 && iteration % options.search_interval == 0)
      graph = research (positions);
    const double share = 1.0 / options.iterations;
    parallelFor (graph->size (), execution.part (iteration * share, (iteration + 1) * share),
                 [&] (std::size_t begin, std::size_t end) {
                   for (auto i = static_cast<std::uint32_t> (begin); i < end; ++i) {
                     const Eigen::Vector3f step = updateStep (i, graph->row (i), positions, normals, options);
                     next[i] = start[i] + capped (positions.offset[i] - start[i] + step, options.max_displacement);
                   }
                 });
    positions.offset.swap (next);
  }
}
} // namespace core
} // namespace pcl_normal_smoothing
