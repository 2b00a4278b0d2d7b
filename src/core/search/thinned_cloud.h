// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kd_tree.h"
#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** A cloud dealt out into parts, each evenly over it: in one of them neighbours are as many, but farther away. */
class ThinnedCloud
{
public:
  /** In which of the parts the neighbours of a node are searched. */
  enum class Parts
  {
    /** All in the same one. */
    ONE,
    /** Each in one that the hash of its coordinates picks, of as many as have about 16,384 points in all: by chance one
      * small part shows what others do not. */
    SOME,
    /** Each in one that the hash of its coordinates picks: a cloud that is smoothed so makes use of all of its points,
      * for neighbours of neighbours lie in other parts. */
    ALL
  };

  /** \param[in] graph of all nodes, at least one
    * \param[in] halvings how often their number is halved; at least 0 */
  ThinnedCloud (const NeighborGraph& graph,
                const Positions& nodes,
                int halvings,
                Parts parts,
                const Execution& execution);

  /** \return after so many halvings at least so many points are left; at least 0 */
  static int
  mostHalvings (std::size_t size, std::size_t left);

  /** Fewer do not tell a surface. */
  static constexpr std::size_t least_size = 300;

  /** The row of a node: the node and its nearest in a part.
    * \param[out] row filled up with the node itself */
  void
  row (std::uint32_t node, std::uint32_t* row, std::uint32_t length, KdTree::Scratch& scratch) const;

private:
  struct Part
  {
    Elements members;
    KdTree tree;
  };

  const Positions& nodes_;
  std::vector<Part> parts_; // a power of two
};
} // namespace core
} // namespace pcl_normal_smoothing
