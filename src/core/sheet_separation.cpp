// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/node_blocks.h>
#include <pcl_normal_smoothing/core/sheet_normals.h>
#include <pcl_normal_smoothing/core/sheet_separation.h>
#include <pcl_normal_smoothing/core/sheet_test.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
/** Nodes with enough neighbours on another sheet.
  * \param[in] nodes that are asked; null: all */
std::vector<std::uint32_t>
nodesBesideOtherSheets (const NeighborGraph& graph,
                        const SheetTest& test,
                        const std::vector<std::uint32_t>* nodes,
                        const Execution& execution)
{
  Numbers others (graph.size (), 0.0f);
  const OtherSheetTest of_rows = test.ofRows (evidence_to_change, others);
  const auto count = [&] (const BlockRows& rows) {
    kernels ().count_others (of_rows, {rows.neighbors, std::min (rows.length, sheet_row_length)});
  };
  if (nodes != nullptr)
    forEachBlockOf (graph, *nodes, sheet_row_length, execution, count);
  else
    forEachBlock (graph, execution, count);
  std::vector<std::uint32_t> found;
  for (std::uint32_t node = 0; node < graph.size (); ++node)
    if (others[node] >= static_cast<float> (min_other_neighbors))
      found.push_back (node);
  return found;
}

/** Nodes one of whose neighbours is among \a nodes. */
std::vector<std::uint32_t>
nodesNear (const NeighborGraph& graph, const std::vector<std::uint32_t>& nodes, const Execution& execution)
{
  std::vector<std::uint8_t> is_one (graph.size ()), is_near (graph.size ());
  for (const std::uint32_t node : nodes)
    is_one[node] = 1;
  parallelFor (graph.size (), execution, [&] (std::size_t begin, std::size_t end) {
    for (std::size_t node = begin; node < end; ++node) {
      const Row row = graph.row (node);
      const std::size_t length = std::min (row.size (), sheet_row_length);
      for (std::size_t j = 0; j < length && !is_near[node]; ++j)
        is_near[node] = is_one[row[j]];
    }
  });
  std::vector<std::uint32_t> near;
  for (std::uint32_t node = 0; node < graph.size (); ++node)
    if (is_near[node])
      near.push_back (node);
  return near;
}

/** Nodes, each once: neighbours of neighbours are mostly the same, and sorting them all would take most of the time. */
class NodeSet
{
public:
  /** \param[in] most nodes that will be inserted, repetitions counted */
  void
  clear (std::size_t most)
  {
    std::size_t size = 64;
    while (size < 2 * most)
      size *= 2;
    table_.assign (size, no_node);
    nodes_.clear ();
  }

  void
  insert (std::uint32_t node)
  {
    const std::uint32_t hash = node * 0x9E3779B1u;
    const std::size_t mask = table_.size () - 1;
    std::size_t place = (hash ^ (hash >> 15)) & mask;
    while (table_[place] != no_node && table_[place] != node)
      place = (place + 1) & mask;
    if (table_[place] == node)
      return;
    table_[place] = node;
    nodes_.push_back (node);
  }

  const std::vector<std::uint32_t>&
  nodes () const
  {
    return nodes_;
  }

private:
  static constexpr auto no_node = std::numeric_limits<std::uint32_t>::max ();

  std::vector<std::uint32_t> table_; // of a power of two, at most half full
  std::vector<std::uint32_t> nodes_;
};

/** Writes the row of \a node, of sheet_row_length, from the neighbours of its neighbours on its own sheet: the first
  * sheet_row_length of each, or long rows would take their length squared in time and memory.
  * \param found for reuse */
void
writeOwnSheet (const NeighborGraph& graph,
               const Positions& positions,
               const SheetTest& test,
               std::uint32_t node,
               NodeSet& found,
               std::uint32_t* out)
{
  const Row row = graph.row (node);
  const std::size_t length = std::min (row.size (), sheet_row_length);
  std::size_t most = 0;
  for (std::size_t j = 0; j < length; ++j)
    most += std::min<std::size_t> (graph.blockLength (row[j] / NeighborGraph::block_size), sheet_row_length);
  found.clear (most);
  for (std::size_t j = 0; j < length; ++j) {
    if (j > 0 && test.isOther (node, row[j], evidence_to_drop))
      continue;
    const Row further = graph.row (row[j]);
    for (std::size_t t = 0; t < std::min (further.size (), sheet_row_length); ++t)
      found.insert (further[t]);
  }

  std::vector<Neighbor> own_sheet;
  for (const std::uint32_t other : found.nodes ())
    if (other != node && !test.isOther (node, other, evidence_to_drop))
      own_sheet.push_back ({squaredLength (positions.difference (node, other)), graph.order ()[other], other});
  const std::size_t size = std::min (own_sheet.size (), length - 1);
  const auto end = own_sheet.begin () + static_cast<std::ptrdiff_t> (size);
  std::nth_element (own_sheet.begin (), end, own_sheet.end ());
  std::sort (own_sheet.begin (), end);
  std::fill_n (out, sheet_row_length, node);
  for (std::size_t j = 0; j < size; ++j)
    out[j + 1] = own_sheet[j].slot;
}
} // namespace

// The row of a node is written from the rows of its neighbours and the normals of theirs. A normal that is not given depends on
// those of the first vote around it, the second also on whether one of the neighbours has others of another sheet near; and the
// first elects among normals of the neighbours, which are estimated from their rows.
int
separationDepth (const SheetSeparationOptions& options)
{
  if (options.oriented_normals != nullptr)
    return 1;
  return std::isfinite (options.distance) ? 5 : -1;
}

NeighborGraph::ConstPtr
separateSheets (const NeighborGraph::ConstPtr& graph,
                const Positions& positions,
                const SheetSeparationOptions& options,
                const Execution& execution)
{
  if (separationDepth (options) < 0)
    return graph;
  const bool oriented = options.oriented_normals != nullptr;
  Vectors normals =
      oriented ? *options.oriented_normals : electNormals (*graph, positions, options.distance, nullptr, execution);
  const SheetTest test (positions, normals, options.distance, oriented);
  std::vector<std::uint32_t> nodes = nodesBesideOtherSheets (*graph, test, nullptr, execution);
  if (!oriented && !nodes.empty ()) {
    const std::vector<std::uint32_t> near = nodesNear (*graph, nodes, execution);
    normals = electAgain (*graph, positions, options.distance, normals, near, execution);
    nodes = nodesBesideOtherSheets (*graph, test, &near, execution);
  }
  if (nodes.empty ())
    return graph;
  std::vector<std::uint32_t> rows (nodes.size () * sheet_row_length);
  parallelFor (
      nodes.size (), execution,
      [&] (std::size_t begin, std::size_t end) {
        NodeSet found;
        for (std::size_t i = begin; i < end; ++i)
          writeOwnSheet (*graph, positions, test, nodes[i], found, rows.data () + i * sheet_row_length);
      },
      64);
  return graph->withRows (nodes, rows, sheet_row_length);
}
} // namespace core
} // namespace pcl_normal_smoothing
