// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>

namespace pcl_normal_smoothing
{
namespace core
{
/** Defines the neighbours of a point: the k nearest, all within a radius, or the k nearest within a radius. */
struct NeighborQuery
{
  /** Number of neighbours, the point itself included; 0: unlimited. */
  std::uint32_t k = 0;
  /** Neighbours are closer than this, in the unit of the searched positions. */
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

/** A neighbour found by a search. */
struct Neighbor
{
  float sq_dist;
  std::uint32_t rank; // decides between equal distances, lowest first
  std::uint32_t slot; // its index in the searched structure

  bool
  operator<(const Neighbor& other) const
  {
    return sq_dist < other.sq_dist || (sq_dist == other.sq_dist && rank < other.rank);
  }
};

} // namespace core
} // namespace pcl_normal_smoothing
