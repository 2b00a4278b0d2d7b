// SPDX-License-Identifier: BSD-3-Clause
#include "neighbor_graph_rows.h"

#include <pcl_normal_smoothing/core/error.h>
#include <pcl_normal_smoothing/core/kd_tree.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>

namespace pcl_normal_smoothing
{
namespace core
{
Positions
gather (const Positions& positions, const Elements& order, const Execution& execution)
{
  Positions result {Vectors (order.size ()), Vectors (order.size ()), positions.unit};
  parallelFor (order.size (), execution, [&] (std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      result.base[i] = positions.base[order[i]];
      result.offset[i] = positions.offset[order[i]];
    }
  });
  return result;
}

Elements
finiteElements (const Positions& positions, const Execution& execution)
{
  const auto isFinite = [&] (std::size_t i) {
    return positions.base[i].allFinite () && positions.offset[i].allFinite ();
  };
  Elements finite (positions.size ());
  std::atomic<bool> all_finite {true};
  parallelFor (finite.size (), execution, [&] (std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      finite[i] = static_cast<std::uint32_t> (i);
      if (!isFinite (i))
        all_finite = false;
    }
  });
  if (!all_finite)
    finite.erase (std::remove_if (finite.begin (), finite.end (), [&] (std::uint32_t i) { return !isFinite (i); }),
                  finite.end ());
  return finite;
}

Row
NeighborGraph::row (std::size_t node) const
{
  const std::size_t block = node / block_size;
  const Row whole (blockRows (block) + node % block_size, blockLength (block), block_size);
  std::size_t size = whole.size ();
  while (size > 1 && whole[size - 1] == node)
    --size;
  return Row (blockRows (block) + node % block_size, size, block_size);
}

std::size_t
NeighborGraph::minRowLength () const
{
  std::size_t length = size () == 0 ? 0 : row (0).size ();
  for (std::size_t node = 1; node < size (); ++node)
    length = std::min (length, row (node).size ());
  return length;
}

NeighborGraph::Ptr
NeighborGraph::withRows (const std::vector<std::uint32_t>& nodes,
                         const std::vector<std::uint32_t>& rows,
                         std::size_t length) const
{
  const auto beginsBlock = [&] (std::size_t i) { return i == 0 || nodes[i] / block_size != nodes[i - 1] / block_size; };
  std::size_t changed_size = 0;
  for (std::size_t i = 0; i < nodes.size (); ++i)
    if (beginsBlock (i))
      changed_size += block_size * blockLength (nodes[i] / block_size);
  const auto changed = std::make_shared<Neighbors> (changed_size);
  auto graph = std::make_shared<NeighborGraph> (*this);
  graph->neighbors_.push_back (changed);

  std::uint32_t *row = nullptr, *end = changed->data ();
  for (std::size_t i = 0; i < nodes.size (); ++i) {
    const std::size_t block = nodes[i] / block_size, lane = nodes[i] % block_size;
    if (beginsBlock (i)) {
      row = end;
      end = std::copy_n (blockRows (block), block_size * blockLength (block), row);
      graph->block_rows_[block] = row;
    }
    // Lanes behind the last node repeat it.
    const std::size_t lanes_end = nodes[i] + 1 == size () ? block_size : lane + 1;
    for (std::size_t j = 0; j < blockLength (block); ++j)
      std::fill (row + j * block_size + lane, row + j * block_size + lanes_end,
                 j < length ? rows[i * length + j] : nodes[i]);
  }
  return graph;
}

namespace
{
/** Every row has this length; 0 = they differ. */
std::size_t
rowLength (const NeighborQuery& query, std::size_t size)
{
  return std::isfinite (query.radius) || query.k == 0 ? 0 : std::min<std::size_t> (query.k, size);
}
} // namespace

NeighborGraph::Ptr
NeighborGraph::build (const Positions& cloud, const NeighborQuery& query, const Execution& execution)
{
  auto graph = std::make_shared<NeighborGraph> ();
  graph->cloud_size_ = cloud.size ();
  const Elements finite = finiteElements (cloud, execution.silent ());
  if (finite.empty ())
    return graph;
  const KdTree tree (gather (cloud, finite, execution.silent ()), finite, execution);
  const auto order = std::make_shared<Elements> (finite.size ());
  parallelFor (order->size (), execution.silent (), [&] (std::size_t begin, std::size_t end) {
    for (std::size_t slot = begin; slot < end; ++slot)
      (*order)[slot] = finite[tree.order ()[slot]];
  });
  graph->order_ = order;

  Rows rows (*graph, rowLength (query, graph->size ()));
  tree.searchAll (query, execution, [&] (std::uint32_t slot, const auto& row) { rows.put (slot, row); });
  rows.finish ();
  return graph;
}

NeighborGraph::Ptr
NeighborGraph::rebuild (const Positions& nodes, const NeighborQuery& query, const Execution& execution) const
{
  auto graph = std::make_shared<NeighborGraph> ();
  graph->cloud_size_ = cloud_size_;
  graph->order_ = order_;
  if (order_->empty ())
    return graph;
  const KdTree tree (nodes, *order_, execution);
  Rows rows (*graph, rowLength (query, graph->size ()));
  tree.searchAll (query, execution, [&] (std::uint32_t slot, const auto& row) {
    rows.put (tree.order ()[slot], row, tree.order ().data ());
  });
  rows.finish ();
  return graph;
}

namespace
{
/** Searches the rows of the points from rows.size () on.
  * \param[out] rows without the point itself; the slots are numbers of points, as the ranks of the tree are */
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
} // namespace

NeighborGraph::Ptr
NeighborGraph::buildAround (const Positions& cloud,
                            const Elements& start,
                            int hops,
                            const NeighborQuery& query,
                            const Execution& execution)
{
  constexpr auto no_node = std::numeric_limits<std::uint32_t>::max ();
  auto graph = std::make_shared<NeighborGraph> ();
  graph->cloud_size_ = cloud.size ();
  const auto nodes = std::make_shared<Elements> (start);
  graph->order_ = nodes;
  if (start.empty ())
    return graph;
  const Elements finite = finiteElements (cloud, execution.silent ());
  const KdTree tree (gather (cloud, finite, execution.silent ()), finite, execution.silent ());
  std::vector<std::uint32_t> node_of (cloud.size (), no_node); // of a point
  for (std::uint32_t node = 0; node < start.size (); ++node)
    node_of[start[node]] = node;

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
  return graph;
}

NeighborGraph::Ptr
NeighborGraph::build (const Positions& cloud, const Search& search, const Execution& execution)
{
  // The tree of our own gives the order in space; the neighbours are the search's.
  const auto ordered = build (cloud, NeighborQuery {1}, execution.part (0, 0.1));
  return ordered->rebuild (gather (cloud, ordered->order ()), search, execution.part (0.1, 1));
}

NeighborGraph::Ptr
NeighborGraph::rebuild (const Positions& nodes, const Search& search, const Execution& execution) const
{
  auto graph = std::make_shared<NeighborGraph> ();
  graph->cloud_size_ = cloud_size_;
  graph->order_ = order_;
  constexpr auto no_node = std::numeric_limits<std::uint32_t>::max ();
  std::vector<std::uint32_t> node_of (cloud_size_, no_node);
  for (std::uint32_t node = 0; node < size (); ++node)
    node_of[order ()[node]] = node;

  Rows rows (*graph, 0);
  parallelFor (size (), execution, [&] (std::size_t begin, std::size_t end) {
    std::vector<std::uint32_t> found;
    std::vector<Neighbor> row;
    for (auto node = static_cast<std::uint32_t> (begin); node < end; ++node) {
      search (order ()[node], found);
      row.clear ();
      for (const std::uint32_t index : found) {
        if (index >= cloud_size_ || node_of[index] == no_node)
          throw Error ("the search object returned point " + std::to_string (index) +
                       ", which is not a finite point of the input cloud: let it search the same cloud");
        if (index != order ()[node])
          row.push_back ({squaredLength (nodes.difference (node, node_of[index])), index, node_of[index]});
      }
      std::sort (row.begin (), row.end ());
      rows.put (node, row);
    }
  });
  rows.finish ();
  return graph;
}
} // namespace core
} // namespace pcl_normal_smoothing
