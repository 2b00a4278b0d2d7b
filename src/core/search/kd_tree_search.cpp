// SPDX-License-Identifier: BSD-3-Clause
#include "kd_tree.h"

#include <algorithm>
#include <cmath>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
constexpr float infinity = std::numeric_limits<float>::infinity ();
constexpr auto no_slot = std::numeric_limits<std::uint32_t>::max ();
// Up to this size, counting the smaller keys of every key beats sorting.
constexpr std::size_t max_ranked = 160;

float
square (float x)
{
  return x * x;
}

/** An upper bound on squared distances up to \a distance, whatever the rounding. */
float
sqReachOf (float distance)
{
  constexpr float rounding = 1 + 1e-5f;
  // Subnormal squares have few digits.
  return square (distance * rounding) + std::numeric_limits<float>::min ();
}

/** The largest squared distance below \a radius, which is excluded. */
float
sqBoundOf (float radius)
{
  return std::isfinite (radius) ? std::nextafter (radius * radius, 0.0f) : infinity;
}

/** The k-th smallest key; may reorder the keys. */
float
kthKey (float* keys, std::size_t size, std::size_t k, std::vector<std::int32_t>& ranks)
{
  ranks.resize (std::max (ranks.size (), max_ranked + block_size));
  if (size <= max_ranked && kernels ().rank_keys (keys, size, ranks.data ())) {
    const auto kth = std::find (ranks.begin (), ranks.end (), static_cast<std::int32_t> (k - 1));
    return keys[kth - ranks.begin ()];
  }
  std::nth_element (keys, keys + (k - 1), keys + size);
  return keys[k - 1];
}

float
distance (const CandidateQuery& a, const CandidateQuery& b)
{
  float sum = 0;
  for (int d = 0; d < 3; ++d)
    sum += square ((a.base[d] - b.base[d]) + (a.offset[d] - b.offset[d]));
  return std::sqrt (sum);
}
} // namespace

void
KdTree::searchAll (const NeighborQuery& query, const Execution& execution, const RowVisitor& visit) const
{
  parallelFor (
      leaf_count_, execution,
      [&] (std::size_t begin, std::size_t end) {
        Scratch scratch;
        for (std::size_t leaf = begin; leaf < end; ++leaf)
          searchLeaf (leaf_count_ - 1 + leaf, query, visit, scratch);
      },
      64);
}

void
KdTree::searchLeaf (std::size_t leaf, const NeighborQuery& query, const RowVisitor& visit, Scratch& scratch) const
{
  const Range own = ranges_[leaf];
  const Box& box = boxes_[leaf];
  const Eigen::Array4f middle = 0.5f * box.low + 0.5f * box.high;
  // The radius of a ball about the leaf's middle that holds k points bounds the distances of the k nearest of every
  // point of the leaf.
  std::size_t branch = leaf;
  while (branch > 0 && ranges_[branch].end - ranges_[branch].begin < 2 * std::size_t (query.k))
    branch = (branch - 1) / 2;
  const float half_diagonal = std::sqrt (sqDistance ({box.low, box.low}, {box.high, box.high}));
  const float ball = query.k == 0 ? infinity : ballRadius ({middle[0], middle[1], middle[2]}, branch, query.k, scratch);
  const float reach = std::min (ball + half_diagonal, query.radius);
  gatherCandidates (box, reach, scratch);

  // The k-th neighbour is also no farther than that of an earlier point, plus the distance to that point.
  const std::size_t count = query.k == 0 ? no_slot : query.k - 1;
  std::vector<std::pair<CandidateQuery, float>> earlier; // with the distance of the last neighbour
  for (std::uint32_t slot = own.begin; slot < own.end; ++slot) {
    CandidateQuery point = slotQuery (slot);
    const Box at = pointBox (point);
    float bound = std::min (reach, ball + std::sqrt (sqDistance ({at.low, at.high}, {middle, middle})) + 2 * box.slack);
    for (const auto& other : earlier)
      bound = std::min (bound, distance (point, other.first) + other.second);
    point.sq_bound = std::min (sqReachOf (bound + box.slack), sqBoundOf (query.radius));
    selectNearest (point, slot, count, scratch);
    if (scratch.row.size () == count && count > 0)
      earlier.emplace_back (point, std::sqrt (scratch.row.back ().sq_dist));
    visit (slot, scratch.row);
  }
}

const std::vector<Neighbor>&
KdTree::search (const Eigen::Vector3f& base,
                const Eigen::Vector3f& offset,
                const NeighborQuery& query,
                Scratch& scratch) const
{
  const Coordinates at = treeCoordinates (base, offset);
  const Box box = makeBox (quadOf (at), quadOf (at));
  std::size_t branch = 0; // the smallest with enough points that contains the point
  while (branch < leaf_count_ - 1 && ranges_[2 * branch + 1].end - ranges_[2 * branch + 1].begin >= 2 * query.k) {
    const bool left = sqDistance (box, boxes_[2 * branch + 1]) <= sqDistance (box, boxes_[2 * branch + 2]);
    branch = 2 * branch + (left ? 1 : 2);
  }
  const float ball = query.k == 0 ? infinity : ballRadius (at, branch, query.k, scratch);
  const float reach = std::min (ball, query.radius);
  gatherCandidates (box, reach, scratch);
  const float sq_bound = std::min (sqReachOf (reach + box.slack), sqBoundOf (query.radius));
  selectNearest ({{base.x (), base.y (), base.z ()}, {offset.x (), offset.y (), offset.z ()}, sq_bound}, no_slot,
                 query.k == 0 ? no_slot : query.k, scratch);
  return scratch.row;
}

float
KdTree::ballRadius (const Coordinates& centre, std::size_t branch, std::size_t k, Scratch& scratch) const
{
  const Range range = ranges_[branch];
  if (range.end - range.begin < k)
    return infinity;
  const std::size_t size = range.end - range.begin;
  scratch.sq_dists.resize (std::max (scratch.sq_dists.size (), size + block_size));
  float* const sq_dists = scratch.sq_dists.data ();
  for (std::size_t i = 0; i < size; ++i) {
    const Coordinates at = slotCoordinates (range.begin + i);
    sq_dists[i] = square (at[0] - centre[0]) + square (at[1] - centre[1]) + square (at[2] - centre[2]);
  }
  return std::sqrt (kthKey (sq_dists, size, k, scratch.ranks)) * (1 + 1e-5f) + boxes_[branch].slack;
}

void
KdTree::nearLeaves (const Box& box, float reach, Scratch& scratch) const
{
  const float sq_reach = sqReachOf (reach);
  std::vector<std::uint32_t>&nodes = scratch.nodes, &children = scratch.children;
  nodes.assign (1, 0);
  for (std::size_t first = 0; first < leaf_count_ - 1; first = 2 * first + 1) {
    children.resize (2 * nodes.size ());
    std::size_t count = 0; // branchless: which child is near is unpredictable
    for (const std::uint32_t node : nodes)
      for (const std::uint32_t child : {2 * node + 1, 2 * node + 2}) {
        children[count] = child;
        count += sqDistance (box, boxes_[child]) <= sq_reach;
      }
    children.resize (count);
    nodes.swap (children);
  }
}

void
KdTree::gatherCandidates (const Box& box, float reach, Scratch& scratch) const
{
  nearLeaves (box, reach, scratch);
  const std::size_t room = (scratch.nodes.size () + 1) * max_leaf_size;
  if (scratch.slots.size () < room) {
    scratch.slots.resize (room);
    for (auto& base : scratch.base)
      base.resize (room);
    scratch.selected.resize (room);
  }
  for (auto& offset : scratch.offset) // empty if this scratch has only served trees without
    if (has_offset_ && offset.size () < room)
      offset.resize (room);
  scratch.sq_dists.resize (std::max (scratch.sq_dists.size (), room));

  scratch.candidate_count = 0;
  for (const std::uint32_t leaf : scratch.nodes) {
    const Range range = ranges_[leaf];
    const std::size_t count = scratch.candidate_count;
    for (std::uint32_t i = 0; i < max_leaf_size; ++i)
      scratch.slots[count + i] = range.begin + i;
    for (int d = 0; d < 3; ++d) { // copying whole leaves, with what lies beyond smaller ones, is faster than counting
      std::copy_n (base_[d].data () + range.begin, max_leaf_size, scratch.base[d].data () + count);
      if (has_offset_)
        std::copy_n (offset_[d].data () + range.begin, max_leaf_size, scratch.offset[d].data () + count);
    }
    scratch.candidate_count += range.end - range.begin;
  }
}

void
KdTree::selectNearest (const CandidateQuery& query, std::uint32_t excluded, std::size_t count, Scratch& scratch) const
{
  Candidates candidates {};
  candidates.count = scratch.candidate_count;
  for (int d = 0; d < 3; ++d) {
    candidates.base[d] = scratch.base[d].data ();
    candidates.offset[d] = has_offset_ ? scratch.offset[d].data () : nullptr;
  }
  const std::size_t found =
      kernels ().select_near (candidates, query, scratch.sq_dists.data (), scratch.selected.data ());
  if (found <= max_ranked && rankRow (found, excluded, count, scratch))
    return;

  std::vector<Neighbor>& row = scratch.row;
  row.clear ();
  for (std::size_t i = 0; i < found; ++i) {
    const std::uint32_t slot = scratch.slots[scratch.selected[i]];
    if (slot != excluded)
      row.push_back ({scratch.sq_dists[i], rank_[slot], slot});
  }
  const auto end = row.begin () + static_cast<std::ptrdiff_t> (std::min (count, row.size ()));
  std::partial_sort (row.begin (), end, row.end ());
  row.erase (end, row.end ());
}

bool
KdTree::rankRow (std::size_t found, std::uint32_t excluded, std::size_t count, Scratch& scratch) const
{
  scratch.ranks.resize (max_ranked + block_size);
  if (!kernels ().rank_keys (scratch.sq_dists.data (), found, scratch.ranks.data ()))
    return false;
  // All distances differ, so the excluded point, at distance 0, comes first.
  const std::size_t skipped = excluded == no_slot ? 0 : 1;
  const std::size_t size = std::min (count, found - skipped);
  std::vector<Neighbor>& row = scratch.row;
  row.resize (size + 1 + skipped); // with a place for unwanted points: a branch on ranks would be unpredictable
  for (std::size_t i = 0; i < found; ++i) {
    const std::uint32_t slot = scratch.slots[scratch.selected[i]];
    const std::size_t place = std::min (static_cast<std::size_t> (scratch.ranks[i]) - skipped, size);
    row[place] = {scratch.sq_dists[i], rank_[slot], slot};
  }
  row.resize (size);
  return true;
}

KdTree::Box
KdTree::pointBox (const CandidateQuery& point) const
{
  const Coordinates at = treeCoordinates (Eigen::Vector3f (point.base[0], point.base[1], point.base[2]),
                                          Eigen::Vector3f (point.offset[0], point.offset[1], point.offset[2]));
  return makeBox (quadOf (at), quadOf (at));
}

KdTree::Coordinates
KdTree::slotCoordinates (std::size_t slot) const
{
  if (has_offset_)
    return treeCoordinates (Eigen::Vector3f (base_[0][slot], base_[1][slot], base_[2][slot]),
                            Eigen::Vector3f (offset_[0][slot], offset_[1][slot], offset_[2][slot]));
  return {base_[0][slot], base_[1][slot], base_[2][slot]}; // here the tree's origin is zero
}

CandidateQuery
KdTree::slotQuery (std::uint32_t slot) const
{
  CandidateQuery query {};
  for (int d = 0; d < 3; ++d) {
    query.base[d] = base_[d][slot];
    query.offset[d] = has_offset_ ? offset_[d][slot] : 0;
  }
  return query;
}
} // namespace core
} // namespace pcl_normal_smoothing
