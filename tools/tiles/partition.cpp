// SPDX-License-Identifier: BSD-3-Clause
#include "partition.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace pcl_normal_smoothing
{
namespace tools
{
Partition::Partition (std::vector<Eigen::Vector3d> sample, std::size_t parts)
{
  split (sample.begin (), sample.end (), parts);
}

void
Partition::split (Point begin, Point end, std::size_t parts)
{
  const std::size_t node = nodes_.size ();
  nodes_.emplace_back ();
  Eigen::AlignedBox3d box;
  std::for_each (begin, end, [&] (const auto& point) { box.extend (point); });
  int axis = 0;
  if (begin != end)
    box.sizes ().maxCoeff (&axis);
  if (parts < 2 || end - begin < 2 || !(box.min ()[axis] < box.max ()[axis])) {
    nodes_[node].part = size_++;
    return;
  }
  const auto less = [axis] (const auto& a, const auto& b) { return a[axis] < b[axis]; };
  const auto share = static_cast<double> (parts / 2) / static_cast<double> (parts);
  Point middle = begin + static_cast<std::ptrdiff_t> (share * static_cast<double> (end - begin));
  std::nth_element (begin, middle, end, less);
  double border = (*middle)[axis];
  if (border == box.min ()[axis]) { // no point would lie below it: take the next larger one
    border = box.max ()[axis];
    std::for_each (begin, end,
                   [&] (const auto& p) { border = p[axis] > box.min ()[axis] ? std::min (border, p[axis]) : border; });
  }
  middle = std::partition (begin, end, [&] (const auto& point) { return point[axis] < border; });
  nodes_[node].axis = axis;
  nodes_[node].border = border;
  split (begin, middle, parts / 2);
  nodes_[node].right = nodes_.size ();
  split (middle, end, parts - parts / 2);
}
} // namespace tools
} // namespace pcl_normal_smoothing
