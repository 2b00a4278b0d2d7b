// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl_normal_smoothing
{
namespace tools
{
/** Divides space into parts that hold equally many points of a sample. */
class Partition
{
public:
  /** \param[in] parts limit on their number; there are fewer if points of the sample coincide */
  Partition (std::vector<Eigen::Vector3d> sample, std::size_t parts);

  std::size_t
  size () const
  {
    return size_;
  }

  /** The number of the part that holds a point. Parts with close numbers lie close together. */
  std::size_t
  partOf (const Eigen::Vector3d& point) const
  {
    std::size_t node = 0;
    while (nodes_[node].axis >= 0)
      node = point[nodes_[node].axis] < nodes_[node].border ? node + 1 : nodes_[node].right;
    return nodes_[node].part;
  }

private:
  struct Node
  {
    int axis = -1; // below 0: a part
    double border = 0;
    std::size_t right = 0; // the left child is the next node
    std::size_t part = 0;
  };

  using Point = std::vector<Eigen::Vector3d>::iterator;

  void
  split (Point begin, Point end, std::size_t parts);

  std::vector<Node> nodes_;
  std::size_t size_ = 0;
};
} // namespace tools
} // namespace pcl_normal_smoothing
