// SPDX-License-Identifier: BSD-3-Clause
#include "thinned_cloud.h"

#include <utility>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
constexpr std::size_t some_points = 16384;

/** The nodes in each of the first \a part_count parts, by the first \a halvings bits of their hashes. */
std::vector<Elements>
membersOf (const Positions& nodes, int halvings, std::size_t part_count)
{
  std::vector<Elements> members (part_count);
  for (std::uint32_t node = 0; node < nodes.size (); ++node)
    if (const std::uint64_t part = std::uint64_t {hashOf (nodes, node)} << halvings >> 32; part < part_count)
      members[part].push_back (node);
  for (Elements& of_part : members)
    if (of_part.empty ()) // if most points are copies of others; a tree needs at least one
      of_part.push_back (0);
  return members;
}

/** \return a power of two */
std::size_t
partCount (std::size_t size, int halvings, ThinnedCloud::Parts parts)
{
  const std::size_t all = std::size_t {1} << halvings;
  if (parts == ThinnedCloud::Parts::ALL)
    return all;
  std::size_t count = 1;
  while (parts == ThinnedCloud::Parts::SOME && count < all && count * (size >> halvings) < some_points)
    count *= 2;
  return count;
}

KdTree
treeOf (const NeighborGraph& graph, const Positions& nodes, const Elements& members, const Execution& execution)
{
  Elements ranks;
  for (const std::uint32_t node : members)
    ranks.push_back (graph.order ()[node]);
  return KdTree (gather (nodes, members, execution), ranks, execution);
}
} // namespace

ThinnedCloud::ThinnedCloud (const NeighborGraph& graph,
                            const Positions& nodes,
                            int halvings,
                            Parts parts,
                            const Execution& execution)
: nodes_ (nodes)
{
  for (Elements& members : membersOf (nodes, halvings, partCount (nodes.size (), halvings, parts))) {
    KdTree tree = treeOf (graph, nodes, members, execution);
    parts_.push_back ({std::move (members), std::move (tree)});
  }
}

int
ThinnedCloud::mostHalvings (std::size_t size, std::size_t left)
{
  int halvings = 0;
  while (size >> (halvings + 1) >= left)
    ++halvings;
  return halvings;
}

void
ThinnedCloud::row (std::uint32_t node, std::uint32_t* row, std::uint32_t length, KdTree::Scratch& scratch) const
{
  std::fill_n (row, length, node);
  const auto& [members, tree] =
      parts_[hashOf (nodes_, node) & (parts_.size () - 1)]; // by other bits than those that choose a node's own part
  std::uint32_t *place = row + 1, *const end = row + length;
  for (const Neighbor& neighbor : tree.search (nodes_.base[node], nodes_.offset[node], {length}, scratch))
    if (const std::uint32_t found = members[tree.order ()[neighbor.slot]]; found != node && place != end)
      *place++ = found;
}
} // namespace core
} // namespace pcl_normal_smoothing
