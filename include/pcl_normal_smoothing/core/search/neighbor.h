// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>

namespace pcl_normal_smoothing
{
namespace core
{
/** Which neighbours a point has: the k nearest, all closer than a radius, or the k nearest closer than a radius. */
struct NeighborQuery
{
  /** Number of neighbours, the point itself included; 0 = as many as there are. */
  std::uint32_t k = 0;
  /** Neighbours are closer than this, in the unit of the positions that are searched. */
  float radius = std::numeric_limits<float>::infinity ();
  /** Points in one place count as one: NeighborGraph::copies. */
  bool distinct = false;

  /** The same query for positions in another unit: see Positions::unit. */
  NeighborQuery
  inUnit (double unit) const
  {
    return {k, static_cast<float> (radius / unit), distinct};
  }
};

/** A neighbour that a search has found. */
struct Neighbor
{
  float sq_dist;
  std::uint32_t rank; // decides between equal distances, the lowest first
  std::uint32_t slot; // where the searched structure keeps it

  bool
  operator<(const Neighbor& other) const
  {
    return sq_dist < other.sq_dist || (sq_dist == other.sq_dist && rank < other.rank);
  }
};

} // namespace core
} // namespace pcl_normal_smoothing
