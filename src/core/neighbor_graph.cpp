// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/error.h>
#include <pcl_normal_smoothing/core/kd_tree.h>
#include <pcl_normal_smoothing/core/neighbor_graph.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace pcl_normal_smoothing
{
namespace core
{
Positions
gather (const Positions& positions, const std::vector<std::uint32_t>& order)
{
  Positions result;
  result.base.reserve (order.size ());
  result.offset.reserve (order.size ());
  for (const std::uint32_t i : order) {
    result.base.push_back (positions.base[i]);
    result.offset.push_back (positions.offset[i]);
  }
  return result;
}

std::vector<std::uint32_t>
finiteElements (const Positions& positions)
{
  std::vector<std::uint32_t> finite;
  finite.reserve (positions.size ());
  for (std::uint32_t i = 0; i < positions.size (); ++i)
    if (positions.base[i].allFinite () && positions.offset[i].allFinite ())
      finite.push_back (i);
  return finite;
}

/** Takes the rows of a graph in any order from any thread. */
class NeighborGraph::Rows
{
public:
  /** \param[in] length of every row, 0 = they differ */
  Rows (NeighborGraph& graph, std::size_t length) : graph_ (graph)
  {
    graph_.stride_ = length;
    if (length > 0)
      graph_.neighbors_.resize (graph_.size () * length);
    else
      rows_.resize (graph_.size ());
  }

  /** \param[in] node_of the node in every slot that \a row names; empty = they are the nodes */
  void
  put (std::uint32_t node, const std::vector<Neighbor>& row, const std::vector<std::uint32_t>& node_of)
  {
    std::uint32_t* out = graph_.neighbors_.data () + node * graph_.stride_;
    if (graph_.stride_ == 0) {
      rows_[node].resize (row.size () + 1);
      out = rows_[node].data ();
    }
    *out++ = node;
    for (const Neighbor& neighbor : row)
      *out++ = node_of.empty () ? neighbor.slot : node_of[neighbor.slot];
  }

  void
  finish ()
  {
    if (graph_.stride_ > 0)
      return;
    graph_.offsets_.assign (1, 0);
    graph_.offsets_.reserve (rows_.size () + 1);
    for (const auto& row : rows_)
      graph_.offsets_.push_back (graph_.offsets_.back () + row.size ());
    graph_.neighbors_.reserve (graph_.offsets_.back ());
    for (const auto& row : rows_)
      graph_.neighbors_.insert (graph_.neighbors_.end (), row.begin (), row.end ());
  }

private:
  NeighborGraph& graph_;
  std::vector<std::vector<std::uint32_t>> rows_; // where lengths differ
};

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
  graph->order_ = finiteElements (cloud);
  if (graph->order_.empty ())
    return graph;
  const KdTree tree (gather (cloud, graph->order_), graph->order_, execution);
  std::vector<std::uint32_t> order (graph->size ());
  std::transform (tree.order ().begin (), tree.order ().end (), order.begin (),
                  [&] (std::uint32_t element) { return graph->order_[element]; });
  graph->order_ = std::move (order);

  Rows rows (*graph, rowLength (query, graph->size ()));
  tree.searchAll (query, execution, [&] (std::uint32_t slot, const auto& row) { rows.put (slot, row, {}); });
  rows.finish ();
  return graph;
}

NeighborGraph::Ptr
NeighborGraph::rebuild (const Positions& nodes, const NeighborQuery& query, const Execution& execution) const
{
  auto graph = std::make_shared<NeighborGraph> ();
  graph->cloud_size_ = cloud_size_;
  graph->order_ = order_;
  if (order_.empty ())
    return graph;
  const KdTree tree (nodes, order_, execution);
  Rows rows (*graph, rowLength (query, graph->size ()));
  tree.searchAll (query, execution, [&] (std::uint32_t slot, const auto& row) {
    rows.put (tree.order ()[slot], row, tree.order ());
  });
  rows.finish ();
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
    node_of[order_[node]] = node;

  Rows rows (*graph, 0);
  parallelFor (size (), execution, [&] (std::size_t begin, std::size_t end) {
    std::vector<std::uint32_t> found;
    std::vector<Neighbor> row;
    for (auto node = static_cast<std::uint32_t> (begin); node < end; ++node) {
      search (order_[node], found);
      row.clear ();
      for (const std::uint32_t index : found) {
        if (index >= cloud_size_ || node_of[index] == no_node)
          throw Error ("the search object returned point " + std::to_string (index) +
                       ", which is not a finite point of the input cloud: let it search the same cloud");
        if (index != order_[node])
          row.push_back ({nodes.difference (node, node_of[index]).squaredNorm (), index, node_of[index]});
      }
      std::sort (row.begin (), row.end ());
      rows.put (node, row, {});
    }
  });
  rows.finish ();
  return graph;
}
} // namespace core
} // namespace pcl_normal_smoothing
