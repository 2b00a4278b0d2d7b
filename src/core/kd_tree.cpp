// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/kd_tree.h>

#include <algorithm>
#include <cmath>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
constexpr std::uint32_t max_leaf_size = 16;
constexpr auto no_slot = std::numeric_limits<std::uint32_t>::max ();
} // namespace

KdTree::KdTree (const Positions& positions, const std::vector<std::uint32_t>& rank, const Execution& execution)
{
  while (positions.size () > max_leaf_size * leaf_count_)
    leaf_count_ *= 2;
  has_offset_ = !std::all_of (positions.offset.begin (), positions.offset.end (), [] (const auto& v) {
    return v.x () == 0 && v.y () == 0 && v.z () == 0;
  });
  if (has_offset_)
    chooseOrigin (positions);

  std::vector<BuildPoint> points (positions.size ());
  parallelFor (points.size (), execution.part (0, 0), [&] (std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      points[i] = {treeCoordinates (positions.base[i], positions.offset[i]), static_cast<std::uint32_t> (i)};
  });
  split (points, execution);
  order_.resize (points.size ());
  for (std::size_t slot = 0; slot < points.size (); ++slot)
    order_[slot] = points[slot].element;
  fillSlots (positions, rank, execution);
}

// Offsets may be larger than the spacing (doubles far from the origin), so the tree takes them in, near a point of the
// cloud. That rounds: look a little farther. What is found is compared by exact distances and does not depend on it.
void
KdTree::chooseOrigin (const Positions& positions)
{
  origin_ = positions.base.front ().cast<double> ();
  float extent = 0;
  for (std::size_t i = 0; i < positions.size (); ++i)
    for (const float t : treeCoordinates (positions.base[i], positions.offset[i]))
      extent = std::max (extent, std::abs (t));
  slack_ = 4 * std::numeric_limits<float>::epsilon () * extent;
}

KdTree::Coordinates
KdTree::treeCoordinates (const Eigen::Vector3f& base, const Eigen::Vector3f& offset) const
{
  const Eigen::Vector3d t = (base.cast<double> () - origin_) + offset.cast<double> ();
  return {static_cast<float> (t.x ()), static_cast<float> (t.y ()), static_cast<float> (t.z ())};
}

void
KdTree::split (std::vector<BuildPoint>& points, const Execution& execution)
{
  const std::size_t node_count = 2 * leaf_count_ - 1;
  ranges_.resize (node_count);
  boxes_.resize (node_count);
  ranges_[0] = {0, static_cast<std::uint32_t> (points.size ())};
  for (std::size_t level_size = 1; level_size <= leaf_count_; level_size *= 2) {
    const std::size_t first = level_size - 1;
    parallelFor (
        level_size,
        execution.part (0, 0),
        [&] (std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i)
            splitNode (first + i, points);
        },
        std::max<std::size_t> (1, level_size / 256));
  }
}

void
KdTree::splitNode (std::size_t node, std::vector<BuildPoint>& points)
{
  const Range range = ranges_[node];
  const auto point = points.begin ();
  Box box {point[range.begin].at, point[range.begin].at};
  for (std::uint32_t i = range.begin; i < range.end; ++i)
    for (int d = 0; d < 3; ++d) {
      box.low[d] = std::min (box.low[d], point[i].at[d]);
      box.high[d] = std::max (box.high[d], point[i].at[d]);
    }
  boxes_[node] = box;
  if (node >= leaf_count_ - 1)
    return;

  int widest = 0;
  for (int d = 1; d < 3; ++d)
    if (box.high[d] - box.low[d] > box.high[widest] - box.low[widest])
      widest = d;
  const std::uint32_t middle = range.begin + (range.end - range.begin) / 2;
  std::nth_element (point + range.begin, point + middle, point + range.end,
                    [widest] (const BuildPoint& a, const BuildPoint& b) { return a.at[widest] < b.at[widest]; });
  ranges_[2 * node + 1] = {range.begin, middle};
  ranges_[2 * node + 2] = {middle, range.end};
}

void
KdTree::fillSlots (const Positions& positions, const std::vector<std::uint32_t>& rank, const Execution& execution)
{
  rank_.resize (order_.size ());
  for (int d = 0; d < 3; ++d) {
    base_[d].resize (order_.size ());
    offset_[d].resize (has_offset_ ? order_.size () : 0);
  }
  parallelFor (order_.size (), execution.part (0, 0), [&] (std::size_t begin, std::size_t end) {
    for (std::size_t slot = begin; slot < end; ++slot) {
      const std::uint32_t element = order_[slot];
      rank_[slot] = rank.empty () ? element : rank[element];
      for (int d = 0; d < 3; ++d) {
        base_[d][slot] = positions.base[element][d];
        if (has_offset_)
          offset_[d][slot] = positions.offset[element][d];
      }
    }
  });
}

void
KdTree::searchAll (const NeighborQuery& query, const Execution& execution, const RowVisitor& visit) const
{
  parallelFor (
      leaf_count_,
      execution,
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
  const std::size_t capacity = query.k == 0 ? order_.size () : query.k - 1;
  scratch.lists.resize (std::max<std::size_t> (scratch.lists.size (), own.end - own.begin));

  // A first bound from the smallest branch that holds enough points.
  std::size_t branch = leaf;
  while (branch > 0 && ranges_[branch].end - ranges_[branch].begin < 2 * std::size_t (query.k))
    branch = (branch - 1) / 2;
  const Range done = ranges_[branch];
  float sq_bound = 0;
  for (std::uint32_t slot = own.begin; slot < own.end; ++slot) {
    NearestList& list = scratch.lists[slot - own.begin];
    list.reset (capacity, query.radius);
    scan (slotVector (base_, slot), slotVector (offset_, slot), done, slot, list);
    sq_bound = std::max (sq_bound, list.bound ());
  }

  gatherLeaves (boxes_[leaf], done, sq_bound, scratch);
  for (std::uint32_t slot = own.begin; slot < own.end; ++slot) {
    NearestList& list = scratch.lists[slot - own.begin];
    const Eigen::Vector3f base = slotVector (base_, slot), offset = slotVector (offset_, slot);
    const Coordinates at = treeCoordinates (base, offset);
    for (const auto& candidate : scratch.leaves) {
      if (candidate.first > list.bound ())
        break;
      if (sqDistance ({at, at}, boxes_[candidate.second]) <= list.bound ())
        scan (base, offset, ranges_[candidate.second], slot, list);
    }
    visit (slot, list.sorted ());
  }
}

const std::vector<Neighbor>&
KdTree::search (const Eigen::Vector3f& base,
                const Eigen::Vector3f& offset,
                const NeighborQuery& query,
                Scratch& scratch) const
{
  scratch.lists.resize (std::max<std::size_t> (scratch.lists.size (), 1));
  NearestList& list = scratch.lists.front ();
  list.reset (query.k == 0 ? order_.size () : query.k, query.radius);
  const Coordinates at = treeCoordinates (base, offset);
  const Box box {at, at};

  // A first bound from the branch that the point falls into, as above.
  std::size_t branch = 0;
  while (branch < leaf_count_ - 1 && ranges_[2 * branch + 1].end - ranges_[2 * branch + 1].begin >= 2 * query.k)
    branch = sqDistance (box, boxes_[2 * branch + 1]) <= sqDistance (box, boxes_[2 * branch + 2]) ? 2 * branch + 1
                                                                                                : 2 * branch + 2;
  const Range done = query.k == 0 ? Range {0, 0} : ranges_[branch];
  scan (base, offset, done, no_slot, list);
  gatherLeaves (box, done, list.bound (), scratch);
  for (const auto& candidate : scratch.leaves) {
    if (candidate.first > list.bound ())
      break;
    scan (base, offset, ranges_[candidate.second], no_slot, list);
  }
  return list.sorted ();
}

void
KdTree::gatherLeaves (const Box& box, Range done, float sq_bound, Scratch& scratch) const
{
  scratch.leaves.clear ();
  scratch.stack.assign (1, 0);
  while (!scratch.stack.empty ()) {
    const std::uint32_t node = scratch.stack.back ();
    scratch.stack.pop_back ();
    const float sq_dist = sqDistance (box, boxes_[node]);
    const bool is_done = ranges_[node].begin >= done.begin && ranges_[node].end <= done.end;
    if (is_done || sq_dist > sq_bound)
      continue;
    if (node >= leaf_count_ - 1)
      scratch.leaves.emplace_back (sq_dist, node);
    else {
      scratch.stack.push_back (2 * node + 1);
      scratch.stack.push_back (2 * node + 2);
    }
  }
  std::sort (scratch.leaves.begin (), scratch.leaves.end ());
}

float
KdTree::sqDistance (const Box& a, const Box& b) const
{
  float sum = 0;
  for (int d = 0; d < 3; ++d) {
    const float gap = std::max (std::max (a.low[d] - b.high[d], b.low[d] - a.high[d]) - slack_, 0.0f);
    sum += gap * gap;
  }
  return sum;
}

void
KdTree::scan (const Eigen::Vector3f& base,
              const Eigen::Vector3f& offset,
              Range range,
              std::uint32_t excluded,
              NearestList& list) const
{
  constexpr std::uint32_t block = 16;
  float sq_dists[block];
  for (std::uint32_t begin = range.begin; begin < range.end; begin += block) {
    const std::uint32_t count = std::min (block, range.end - begin);
    if (has_offset_)
      for (std::uint32_t i = 0; i < count; ++i) {
        const float dx = (base_[0][begin + i] - base.x ()) + (offset_[0][begin + i] - offset.x ());
        const float dy = (base_[1][begin + i] - base.y ()) + (offset_[1][begin + i] - offset.y ());
        const float dz = (base_[2][begin + i] - base.z ()) + (offset_[2][begin + i] - offset.z ());
        sq_dists[i] = (dx * dx + dy * dy) + dz * dz;
      }
    else
      for (std::uint32_t i = 0; i < count; ++i) {
        const float dx = base_[0][begin + i] - base.x ();
        const float dy = base_[1][begin + i] - base.y ();
        const float dz = base_[2][begin + i] - base.z ();
        sq_dists[i] = (dx * dx + dy * dy) + dz * dz;
      }
    for (std::uint32_t i = 0; i < count; ++i)
      if (sq_dists[i] <= list.bound () && begin + i != excluded)
        list.insert ({sq_dists[i], rank_[begin + i], begin + i});
  }
}

Eigen::Vector3f
KdTree::slotVector (const std::array<std::vector<float>, 3>& columns, std::uint32_t slot) const
{
  return columns[0].empty () ? Eigen::Vector3f (0, 0, 0)
                             : Eigen::Vector3f (columns[0][slot], columns[1][slot], columns[2][slot]);
}
} // namespace core
} // namespace pcl_normal_smoothing
