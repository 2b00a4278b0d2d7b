// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kd_tree.h"
#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** A cloud split into parts that each cover it evenly: within a part, neighbours are as many, but farther away. */
class ThinnedCloud
{
public:
  /** The part in which the neighbours of a node are searched. */
  enum class Parts
  {
    /** The same for all nodes. */
    ONE,
    /** Chosen by a hash of the node's coordinates, out of as many parts as have about 16,384 points in all: a single
      * small part might differ from others by chance. */
    SOME,
    /** Chosen by a hash of the node's coordinates, out of all parts: smoothing such a cloud uses all of its points,
      * as neighbours of neighbours are in other parts. */
    ALL
  };

  /** \param[in] graph of all nodes, at least one
    * \param[in] halvings of the number of nodes, at least 0 */
  ThinnedCloud (const NeighborGraph& graph,
                const Positions& nodes,
                int halvings,
                Parts parts,
                const Execution& execution);

  /** \return how often \a size can be halved with at least \a left points remaining; at least 0 */
  static int
  mostHalvings (std::size_t size, std::size_t left);

  /** Fewer points do not show a surface. */
  static constexpr std::size_t least_size = 300;

  /** The row of a node: the node and its nearest in its part.
    * \param[out] row padded with the node itself */
  void
  row (std::uint32_t node, std::uint32_t* row, std::uint32_t length, KdTree::Scratch& scratch) const;

private:
  struct Part
  {
    Elements members;
    KdTree tree;
  };

  const Positions& nodes_;
  std::vector<Part> parts_; // their number is a power of two
};
} // namespace core
} // namespace pcl_normal_smoothing
