// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../kernels.h"
#include <pcl_normal_smoothing/core/parallel_for.h>
#include <pcl_normal_smoothing/core/positions.h>
#include <pcl_normal_smoothing/core/search/neighbor.h>

#include <algorithm>
#include <array>

namespace pcl_normal_smoothing
{
namespace core
{
/** A balanced kd-tree that answers the queries of all its points together, leaf by leaf.
  *
  * Each leaf gathers once the leaves that can hold neighbours of any of its points; distances are then computed over
  * contiguous arrays. They are ((dx^2 + dy^2) + dz^2) in float, as in FLANN, and the result is exact: rows are
  * ordered by (squared distance, rank), and a tie at the k-th place goes to the lowest rank. */
class KdTree
{
public:
  /** Buffers reused by the queries of one thread. */
  struct Scratch
  {
    std::vector<std::uint32_t> nodes;         // nearby nodes of a level
    std::vector<std::uint32_t> children;      // their children
    std::size_t candidate_count = 0;          // the arrays below never shrink
    std::vector<std::uint32_t> slots;         // of the candidates
    std::array<std::vector<float>, 3> base;   // likewise
    std::array<std::vector<float>, 3> offset; // likewise
    std::vector<std::uint32_t> selected;      // candidates within the bound
    std::vector<float> sq_dists;              // their squared distances
    std::vector<std::int32_t> ranks;          // number of smaller distances
    std::vector<Neighbor> row;
  };

  /** Receives the neighbours of the point in a slot, without that point. Called from many threads. */
  using RowVisitor = std::function<void (std::uint32_t slot, const std::vector<Neighbor>& row)>;

  /** \param[in] positions at least one point, all finite
    * \param[in] rank decides ties, one per point; empty: the point's own number */
  KdTree (const Positions& positions, const Elements& rank, const Execution& execution);

  /** The number of the point in every slot. Slots are numbered along the leaves, so they follow space. */
  const Elements&
  order () const
  {
    return order_;
  }

  /** Hands the neighbours of every point to \a visit; query.k counts the point itself. */
  void
  searchAll (const NeighborQuery& query, const Execution& execution, const RowVisitor& visit) const;

  /** The neighbours of any finite point (as in Positions), nearest first; query.k counts all points found.
    * \return valid until \a scratch is used again */
  const std::vector<Neighbor>&
  search (const Eigen::Vector3f& base,
          const Eigen::Vector3f& offset,
          const NeighborQuery& query,
          Scratch& scratch) const;

private:
  static constexpr std::uint32_t max_leaf_size = 16;

  using Coordinates = std::array<float, 3>;
  struct Box // arrays of four, for vector instructions; the last is 0
  {
    Eigen::Array4f low, high;
    float slack = 0; // upper bound on the rounding error of its coordinates
  };
  struct Range // of slots
  {
    std::uint32_t begin, end;
  };
  struct BuildPoint
  {
    Coordinates at;
    std::uint32_t element;
  };
  using BuildPoints = PaddedVector<BuildPoint>;

  void
  chooseOrigin (const Positions& positions);

  Coordinates
  treeCoordinates (const Eigen::Vector3f& base, const Eigen::Vector3f& offset) const;

  void
  split (BuildPoints& points, const Execution& execution);

  void
  splitNode (std::size_t node, BuildPoints& points);

  void
  splitBranch (std::size_t node, BuildPoints& points);

  void
  fillSlots (const Positions& positions, const Elements& rank, const Execution& execution);

  static Eigen::Array4f
  quadOf (const Coordinates& at)
  {
    return {at[0], at[1], at[2], 0};
  }

  /** Radius of a ball about \a centre that holds \a k points of \a branch; infinity if it has fewer. */
  float
  ballRadius (const Coordinates& centre, std::size_t branch, std::size_t k, Scratch& scratch) const;

  /** Sets scratch.nodes to the leaves within \a reach of \a box. */
  void
  nearLeaves (const Box& box, float reach, Scratch& scratch) const;

  /** Makes all points of the leaves within \a reach of \a box candidates. */
  void
  gatherCandidates (const Box& box, float reach, Scratch& scratch) const;

  /** Sets scratch.row to the nearest candidates within the bound of \a query, at most \a count, without \a excluded. */
  void
  selectNearest (const CandidateQuery& query, std::uint32_t excluded, std::size_t count, Scratch& scratch) const;

  /** The same for \a found selected candidates, by counting smaller distances; false if some are equal. */
  bool
  rankRow (std::size_t found, std::uint32_t excluded, std::size_t count, Scratch& scratch) const;

  /** A lower bound on the squared distances between the points of two boxes. */
  static float
  sqDistance (const Box& a, const Box& b)
  {
    const Eigen::Array4f gaps = (a.low - b.high).max (b.low - a.high) - (a.slack + b.slack);
    return gaps.max (Eigen::Array4f::Zero ()).square ().sum ();
  }

  /** Computes its slack too. */
  Box
  makeBox (const Eigen::Array4f& low, const Eigen::Array4f& high) const;

  void
  searchLeaf (std::size_t leaf, const NeighborQuery& query, const RowVisitor& visit, Scratch& scratch) const;

  Box
  pointBox (const CandidateQuery& point) const;

  Coordinates
  slotCoordinates (std::size_t slot) const;

  CandidateQuery
  slotQuery (std::uint32_t slot) const;

  std::size_t leaf_count_ = 1;  // a power of two; the leaves are the last leaf_count_ nodes
  PaddedVector<Range> ranges_;  // per node; the children of node i are 2i + 1 and 2i + 2
  PaddedVector<Box> boxes_;     // per node, in the tree's coordinates
  Elements order_;              // slot -> element
  Elements rank_;               // slot -> rank
  std::array<Numbers, 3> base_; // slot -> x, y, z
  std::array<Numbers, 3> offset_;
  bool has_offset_ = false;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero (); // of the tree's coordinates, which only decide where to look
};
} // namespace core
} // namespace pcl_normal_smoothing
