// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/kd_tree.h>
#include <pcl_normal_smoothing/core/neighbor_graph.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** A part of the nodes of a cloud, evenly over it, in which neighbours are searched: of as many, but farther away. */
class ThinnedCloud
{
public:
  /** \param[in] graph of all nodes, at least one
    * \param[in] halvings how often their number is halved; at least one node is left. A thinner cloud is part of a denser one */
  ThinnedCloud (const NeighborGraph& graph, const Positions& nodes, int halvings, const Execution& execution);

  /** \return so many halvings leave enough to tell the surface: a thousand points; at least 0 */
  static int
  mostHalvings (std::size_t size);

  /** The row of a node, of this cloud or not: the node and its nearest in this cloud.
    * \param[out] row filled up with the node itself */
  void
  row (std::uint32_t node, std::uint32_t* row, std::uint32_t length, KdTree::Scratch& scratch) const;

private:
  const Positions& nodes_;
  Elements members_;
  KdTree tree_;
};
} // namespace core
} // namespace pcl_normal_smoothing
