// SPDX-License-Identifier: BSD-3-Clause
#include "kd_tree.h"
#include "select_nth.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace pcl_normal_smoothing
{
namespace core
{
KdTree::KdTree (const Positions& positions, const Elements& rank, const Execution& execution)
{
  while (positions.size () > max_leaf_size * leaf_count_)
    leaf_count_ *= 2;
  has_offset_ = hasOffsets (positions);
  if (has_offset_)
    chooseOrigin (positions);

  BuildPoints points (positions.size ());
  parallelFor (points.size (), execution.part (0, 0), [&] (std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      points[i] = {treeCoordinates (positions.base[i], positions.offset[i]), static_cast<std::uint32_t> (i)};
  });
  split (points, execution);
  order_.resize (points.size ());
  parallelFor (points.size (), execution.part (0, 0), [&] (std::size_t begin, std::size_t end) {
    for (std::size_t slot = begin; slot < end; ++slot)
      order_[slot] = points[slot].element;
  });
  BuildPoints ().swap (points); // keeps the peak of memory low
  fillSlots (positions, rank, execution);
}

// Offsets may exceed the spacing (doubles far from the origin), so the tree's coordinates include them, relative to an
// origin near the middle of the cloud. They are rounded, and searches reach farther by the slack of a box, which is
// larger only for points far away. Candidates are compared by exact distances, so the result does not depend on it.
void
KdTree::chooseOrigin (const Positions& positions)
{
  std::vector<float> sample;
  for (int d = 0; d < 3; ++d) {
    sample.clear ();
    for (std::size_t i = 0; i < positions.size (); i += positions.size () / 64 + 1)
      sample.push_back (positions.base[i][d]);
    const auto middle = sample.begin () + static_cast<std::ptrdiff_t> (sample.size () / 2);
    std::nth_element (sample.begin (), middle, sample.end ());
    origin_[d] = *middle;
  }
}

KdTree::Box
KdTree::makeBox (const Eigen::Array4f& low, const Eigen::Array4f& high) const
{
  Box box {low, high};
  const float largest = has_offset_ ? low.abs ().max (high.abs ()).maxCoeff () : 0;
  box.slack = 4 * std::numeric_limits<float>::epsilon () * largest;
  return box;
}

KdTree::Coordinates
KdTree::treeCoordinates (const Eigen::Vector3f& base, const Eigen::Vector3f& offset) const
{
  const Eigen::Vector3d t = (base.cast<double> () - origin_) + offset.cast<double> ();
  return {static_cast<float> (t.x ()), static_cast<float> (t.y ()), static_cast<float> (t.z ())};
}

void
KdTree::split (BuildPoints& points, const Execution& execution)
{
  const std::size_t node_count = 2 * leaf_count_ - 1;
  ranges_.resize (node_count);
  boxes_.resize (node_count);
  ranges_[0] = {0, static_cast<std::uint32_t> (points.size ())};
  // Level by level at the top; below, each thread takes whole branches, which stay in its cache.
  const std::size_t branches = std::max<std::size_t> (1, leaf_count_ / 64);
  for (std::size_t level_size = 1; level_size < branches; level_size *= 2)
    parallelFor (
        level_size, execution.part (0, 0),
        [&] (std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i)
            splitNode (level_size - 1 + i, points);
        },
        std::max<std::size_t> (1, level_size / 256));
  parallelFor (
      branches, execution.part (0, 0),
      [&] (std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          splitBranch (branches - 1 + i, points);
      },
      std::max<std::size_t> (1, branches / 256));
}

void
KdTree::splitBranch (std::size_t node, BuildPoints& points)
{
  splitNode (node, points);
  if (node >= leaf_count_ - 1)
    return;
  splitBranch (2 * node + 1, points);
  splitBranch (2 * node + 2, points);
}

void
KdTree::splitNode (std::size_t node, BuildPoints& points)
{
  const Range range = ranges_[node];
  BuildPoint* const point = points.data ();
  const auto quad = [&] (std::uint32_t i) { // the last number has no meaning
    Eigen::Array4f numbers;
    static_assert (sizeof numbers == sizeof (BuildPoint), "a point is copied whole");
    std::memcpy (numbers.data (), point + i, sizeof numbers);
    return numbers;
  };
  Eigen::Array4f low = quad (range.begin), high = low;
  for (std::uint32_t i = range.begin; i < range.end; ++i) {
    low = low.min (quad (i));
    high = high.max (quad (i));
  }
  low[3] = high[3] = 0;
  boxes_[node] = makeBox (low, high);
  if (node >= leaf_count_ - 1)
    return;

  Eigen::Index widest;
  (high - low).maxCoeff (&widest);
  const std::uint32_t middle = range.begin + (range.end - range.begin) / 2;
  selectNth (point + range.begin, point + middle, point + range.end,
             [widest] (const BuildPoint& p) { return p.at[static_cast<std::size_t> (widest)]; });
  ranges_[2 * node + 1] = {range.begin, middle};
  ranges_[2 * node + 2] = {middle, range.end};
}

void
KdTree::fillSlots (const Positions& positions, const Elements& rank, const Execution& execution)
{
  rank_.resize (order_.size ());
  for (int d = 0; d < 3; ++d) {
    base_[d].resize (order_.size () + max_leaf_size);
    offset_[d].resize (has_offset_ ? order_.size () + max_leaf_size : 0);
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

} // namespace core
} // namespace pcl_normal_smoothing
