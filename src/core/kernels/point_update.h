// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "local_points.h"
#include "normal_filter.h"

namespace pcl_normal_smoothing
{
namespace core
{
namespace PCL_NORMAL_SMOOTHING_ISA
{
/** A neighbour and its plane, as needed by eqs. 8 and 9. Copied member by member, like Lanes3. */
struct NeighborPlane
{
  Lanes3 normal;
  Lanes sq_dist, cosine, height;

  NeighborPlane () = default;

  LANES_INLINE
  NeighborPlane (Lanes3 of_normal, Lanes of_sq_dist, Lanes of_cosine, Lanes of_height)
  : normal (of_normal), sq_dist (of_sq_dist), cosine (of_cosine), height (of_height)
  {}

  LANES_INLINE
  NeighborPlane (const NeighborPlane& other)
  : normal (other.normal), sq_dist (other.sq_dist), cosine (other.cosine), height (other.height)
  {}

  LANES_INLINE NeighborPlane&
  operator= (const NeighborPlane& other)
  {
    normal = other.normal, sq_dist = other.sq_dist, cosine = other.cosine, height = other.height;
    return *this;
  }
};

/** The neighbours named by \a index. */
template <UpdateKind kind>
LANES_INLINE NeighborPlane
neighborPlane (const PointUpdateStep& step, const Points& points, Lanes3 own_normal, const std::uint32_t* index)
{
  Lanes3 normal;
  const Lanes3 difference = points.difference (index, step.nodes.normals, normal);
  const Lanes cosine = dot (own_normal, normal);
  Lanes height = dot (normal, difference); // eq. 8, where the sign of n_j cancels
  if (kind != UpdateKind::PAPER)
    height = 0.5f * (turned (dot (own_normal, difference), cosine, step.oriented) + height);
  return {normal, dot (difference, difference), cosine, height};
}

/** 1 / (2 sigma_c^2) of eq. 9, sigma_c being the current distance of the farthest neighbour; 0 where that is 0. */
template <typename Neighbors>
LANES_INLINE Lanes
reachFactor (const Neighbors& neighbors, const BlockRows& rows)
{
  Lanes farthest = {};
  for (std::size_t j = 1; j < rows.length; ++j)
    farthest = maximum (farthest, neighbors (j).sq_dist);
  return farthest > 0 ? 1 / (2 * farthest) : splat (0);
}

/** One iteration of eq. 8 (Sun et al. 2007), or of the variant \a kind.
  * \tparam complete all nodes have normals, and the rows of the lanes' nodes are as long as the block's */
template <UpdateKind kind, bool complete>
LANES_INLINE void
updatePoints (const PointUpdateStep& step, const BlockRows& rows, int first)
{
  const std::uint32_t* own = rows.neighbors + first;
  const Points points (step.nodes.base, step.nodes.offset, own);
  const Lanes3 own_normal = load3 (step.nodes.normals, own);
  const auto read = [&] (std::size_t j)
                        LANES_LAMBDA { return neighborPlane<kind> (step, points, own_normal, own + block_size * j); };
  const NeighborValues<NeighborPlane, decltype (read)> neighbors (read, rows.length);
  const Lanes reach_factor = reachFactor (neighbors, rows) * step.reach_scale * load1OrOne (step.reach_factors, own);
  const Lanes residual_factor = step.residual_factor / load1OrOne (step.variance_factors, own);
  Lanes3 sum = {};
  // The point itself counts too: it adds nothing to the sum.
  Lanes weights = own_normal.x == own_normal.x ? splat (1) : splat (0);
  for (std::size_t j = 1; j < rows.length; ++j) {
    const NeighborPlane neighbor = neighbors (j);
    const Lanes height = neighbor.height, x = 1 - similarity (neighbor.cosine, step.oriented);
    // Eq. 9, both Gaussians in one exponential.
    const Lanes exponent = neighbor.sq_dist * reach_factor + x * x * step.normal_factor;
    const Lanes weight =
        kind == UpdateKind::ROBUST ? bell (exponent + height * height * residual_factor) : expOfMinus (exponent);
    const Lanes3 term = (weight * height) * neighbor.normal;
    const Mask counts = (x == x) & isOther (own + block_size * j, own);
    weights += complete ? weight : counts ? weight : splat (0);
    sum = sum + (complete ? term : choose (counts, term, Lanes3 {}));
  }
  const Lanes scale = weights > 0 ? 1 / weights : splat (0);
  const Lanes3 start = load3OrZero (step.start, own);
  const Lanes3 displacement = (load3OrZero (step.nodes.offset, own) - start) + scale * sum;
  store3 (step.moved, own, start + capped (displacement, step.max_displacement));
}
} // namespace PCL_NORMAL_SMOOTHING_ISA
} // namespace core
} // namespace pcl_normal_smoothing
