// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

namespace pcl_normal_smoothing
{
namespace core
{
/** Which neighbours a point has: the k nearest, all closer than a radius, or the k nearest closer than a radius. */
struct NeighborQuery
{
  /** Number of neighbours, the point itself included; 0 = as many as there are. */
  std::uint32_t k = 0;
  /** Neighbours are closer than this, in the cloud's unit. */
  float radius = std::numeric_limits<float>::infinity ();
};

/** A neighbour that a search has found. */
struct Neighbor
{
  float sq_dist;
  std::uint32_t rank; // decides between equal distances, the lowest first
  std::uint32_t slot; // where the searched structure keeps it

  bool
  operator< (const Neighbor& other) const
  {
    return sq_dist < other.sq_dist || (sq_dist == other.sq_dist && rank < other.rank);
  }
};

/** The nearest neighbours seen so far, by (squared distance, rank). */
class NearestList
{
public:
  /** Empties the list.
    * \param[in] capacity how many to keep at most
    * \param[in] radius only what is closer is kept */
  void
  reset (std::size_t capacity, float radius);

  /** Squared distance above which nothing enters any more. */
  float
  bound () const
  {
    return bound_.sq_dist;
  }

  void
  insert (const Neighbor& neighbor)
  {
    if (neighbor < bound_)
      place (neighbor);
  }

  /** The neighbours in order; the list takes no more until it is reset. */
  const std::vector<Neighbor>&
  sorted ();

private:
  void
  place (const Neighbor& neighbor);

  std::vector<Neighbor> neighbors_;
  Neighbor bound_ {};
  std::size_t capacity_ = 0;
};
} // namespace core
} // namespace pcl_normal_smoothing
