// SPDX-License-Identifier: BSD-3-Clause
#include "neighbor_graph_rows.h"

#include "kd_tree.h"

#include <numeric>
#include <unordered_set>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
/** Searches the rows of \a points from the rows.size ()-th on.
  * \param[out] rows without the point itself; slots, like the ranks of the tree, are numbers of points */
void
searchRows (const KdTree& tree,
            const Positions& cloud,
            const Elements& points,
            const NeighborQuery& query,
            const Execution& execution,
            std::vector<std::vector<Neighbor>>& rows)
{
  const std::size_t first = rows.size ();
  rows.resize (points.size ());
  parallelFor (rows.size () - first, execution, [&] (std::size_t begin, std::size_t end) {
    KdTree::Scratch scratch;
    for (std::size_t i = first + begin; i < first + end; ++i)
      for (const Neighbor& found : tree.search (cloud.base[points[i]], cloud.offset[points[i]], query, scratch))
        if (found.rank != points[i] && (query.k == 0 || rows[i].size () + 1 < query.k))
          rows[i].push_back ({found.sq_dist, found.rank, found.rank});
  });
}

/** \return the first point in the place of each of \a points, without repetitions */
Elements
originalsOf (const Elements& points, const Copies& copies, std::size_t cloud_size)
{
  if (copies.points.empty ())
    return points;
  std::vector<std::uint32_t> original_of (cloud_size);
  std::iota (original_of.begin (), original_of.end (), 0);
  for (std::size_t i = 0; i < copies.points.size (); ++i)
    original_of[copies.points[i]] = copies.originals[i];
  std::unordered_set<std::uint32_t> seen;
  Elements originals;
  for (const std::uint32_t point : points)
    if (seen.insert (original_of[point]).second)
      originals.push_back (original_of[point]);
  return originals;
}
} // namespace

NeighborGraph::Ptr
NeighborGraph::buildAround (const Positions& cloud,
                            const Elements& start,
                            int hops,
                            const NeighborQuery& query,
                            const Execution& execution)
{
  auto graph = std::make_shared<NeighborGraph> ();
  graph->cloud_size_ = cloud.size ();
  if (start.empty ())
    return graph;
  Elements finite = finiteElements (cloud, execution.silent ());
  const Copies copies = query.distinct ? takeOutCopies (cloud, execution.silent (), finite) : Copies ();
  const auto nodes = std::make_shared<Elements> (originalsOf (start, copies, cloud.size ()));
  graph->order_ = nodes;
  const KdTree tree (gather (cloud, finite, execution.silent ()), finite, execution.silent ());
  std::vector<std::uint32_t> node_of (cloud.size (), no_node); // per point
  for (std::uint32_t node = 0; node < nodes->size (); ++node)
    node_of[(*nodes)[node]] = node;

  std::vector<std::vector<Neighbor>> rows;
  for (int hop = 0; hop <= hops; ++hop) {
    const std::size_t reached = rows.size ();
    searchRows (tree, cloud, *nodes, query, execution.part (hop, hop + 1, hops + 1), rows);
    for (std::size_t node = reached; node < rows.size (); ++node)
      for (const Neighbor& neighbor : rows[node])
        if (node_of[neighbor.slot] == no_node) {
          node_of[neighbor.slot] = static_cast<std::uint32_t> (nodes->size ());
          nodes->push_back (neighbor.slot);
        }
  }
  Rows of_graph (*graph, 0);
  for (std::uint32_t node = 0; node < rows.size (); ++node)
    of_graph.put (node, rows[node], node_of.data ());
  of_graph.finish ();
  graph->setCopies (copies);
  return graph;
}
} // namespace core
} // namespace pcl_normal_smoothing
