// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/noise_sample.h>
#include <pcl_normal_smoothing/core/thinned_cloud.h>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
constexpr std::size_t smallest_size = 1000;

Elements
membersOf (const Positions& nodes, int halvings, const Execution& execution)
{
  const std::vector<std::uint32_t> members = sampleNodes (nodes, nodes.size (), nodes.size () >> halvings, execution);
  return members.empty () ? Elements (1, 0) : Elements (members.begin (), members.end ());
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
                            const Execution& execution)
: nodes_ (nodes), members_ (membersOf (nodes, halvings, execution)), tree_ (treeOf (graph, nodes, members_, execution))
{}

int
ThinnedCloud::mostHalvings (std::size_t size)
{
  int halvings = 0;
  while (size >> (halvings + 1) >= smallest_size)
    ++halvings;
  return halvings;
}

void
ThinnedCloud::row (std::uint32_t node, std::uint32_t* row, std::uint32_t length, KdTree::Scratch& scratch) const
{
  std::fill_n (row, length, node);
  std::uint32_t *place = row + 1, *const end = row + length;
  for (const Neighbor& neighbor : tree_.search (nodes_.base[node], nodes_.offset[node], {length}, scratch))
    if (const std::uint32_t found = members_[tree_.order ()[neighbor.slot]]; found != node && place != end)
      *place++ = found;
}
} // namespace core
} // namespace pcl_normal_smoothing
