// SPDX-License-Identifier: BSD-3-Clause
#include "neighbor_graph_rows.h"

#include "kd_tree.h"
#include <pcl_normal_smoothing/core/error.h>

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

std::vector<std::uint32_t>
NeighborGraph::nodesOfPoints () const
{
  std::vector<std::uint32_t> node_of (cloud_size_, no_node);
  for (std::uint32_t node = 0; node < size (); ++node)
    node_of[order ()[node]] = node;
  for (std::size_t i = 0; i < copies ().points.size (); ++i)
    node_of[copies ().points[i]] = copies ().originals[i];
  return node_of;
}

void
NeighborGraph::setCopies (const Copies& copies)
{
  if (copies.points.empty ())
    return;
  const std::vector<std::uint32_t> node_of = nodesOfPoints ();
  auto of_nodes = std::make_shared<Copies> ();
  of_nodes->points.reserve (copies.points.size ());
  of_nodes->originals.reserve (copies.points.size ());
  for (std::size_t i = 0; i < copies.points.size (); ++i)
    if (const std::uint32_t node = node_of[copies.originals[i]]; node != no_node) {
      of_nodes->points.push_back (copies.points[i]);
      of_nodes->originals.push_back (node);
    }
  copies_ = of_nodes;
}

Elements
NeighborGraph::points () const
{
  Elements points = order ();
  points.insert (points.end (), copies ().points.begin (), copies ().points.end ());
  return points;
}

void
NeighborGraph::repeatForCopies (Vectors& of_nodes) const
{
  of_nodes.reserve (of_nodes.size () + copies ().points.size ());
  for (const std::uint32_t node : copies ().originals)
    of_nodes.push_back (of_nodes[node]);
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
    // Lanes beyond the last node repeat it.
    const std::size_t lanes_end = nodes[i] + 1 == size () ? block_size : lane + 1;
    for (std::size_t j = 0; j < blockLength (block); ++j)
      std::fill (row + j * block_size + lane, row + j * block_size + lanes_end,
                 j < length ? rows[i * length + j] : nodes[i]);
    // Rows only get shorter, so the shortest is the previous one or one of these.
    graph->min_row_length_ = std::min (graph->min_row_length_, graph->row (nodes[i]).size ());
  }
  return graph;
}

namespace
{
/** The length of every row; 0 if they differ. */
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
  Elements finite = finiteElements (cloud, execution.silent ());
  if (finite.empty ())
    return graph;
  const Copies copies = query.distinct ? takeOutCopies (cloud, execution.silent (), finite) : Copies ();
  const KdTree tree (gather (cloud, finite, execution.silent ()), finite, execution);
  const auto order = std::make_shared<Elements> (finite.size ());
  parallelFor (order->size (), execution.silent (), [&] (std::size_t begin, std::size_t end) {
    for (std::size_t slot = begin; slot < end; ++slot)
      (*order)[slot] = finite[tree.order ()[slot]];
  });
  graph->order_ = order;
  graph->setCopies (copies);

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
  graph->copies_ = copies_;
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

NeighborGraph::Ptr
NeighborGraph::build (const Positions& cloud, const Search& search, const Execution& execution, bool distinct)
{
  // Our own tree gives the order in space; the neighbours are from the search.
  NeighborQuery order_alone {1};
  order_alone.distinct = distinct;
  const auto ordered = build (cloud, order_alone, execution.part (0, 0.1));
  return ordered->rebuild (gather (cloud, ordered->order (), execution.silent ()), search, execution.part (0.1, 1));
}

NeighborGraph::Ptr
NeighborGraph::rebuild (const Positions& nodes, const Search& search, const Execution& execution) const
{
  auto graph = std::make_shared<NeighborGraph> ();
  graph->cloud_size_ = cloud_size_;
  graph->order_ = order_;
  graph->copies_ = copies_;
  const std::vector<std::uint32_t> node_of = nodesOfPoints ();

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
        const std::uint32_t neighbor = node_of[index];
        if (neighbor != node)
          row.push_back ({squaredLength (nodes.difference (node, neighbor)), order ()[neighbor], neighbor});
      }
      std::sort (row.begin (), row.end ());
      const auto isOnePlace = [] (const Neighbor& a, const Neighbor& b) { return a.slot == b.slot; };
      row.erase (std::unique (row.begin (), row.end (), isOnePlace), row.end ());
      rows.put (node, row);
    }
  });
  rows.finish ();
  return graph;
}
} // namespace core
} // namespace pcl_normal_smoothing
