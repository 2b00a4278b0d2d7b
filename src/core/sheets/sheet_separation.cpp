// SPDX-License-Identifier: BSD-3-Clause
#include "../nodes_where.h"
#include "sheet_normals.h"

#include "../search/node_blocks.h"
#include "sheet_criterion.h"
#include "sheet_separation.h"

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
  * \param[in] nodes to examine; null: all */
std::vector<std::uint32_t>
nodesBesideOtherSheets (const NeighborGraph& graph,
                        const SheetCriterion& criterion,
                        const std::vector<std::uint32_t>* nodes,
                        const Execution& execution)
{
  Numbers others (graph.size (), 0.0f);
  const OtherSheetCount of_rows = criterion.ofRows (evidence_to_change, others);
  forEachBlockOf (graph, nodes, sheet_row_length, execution,
                  [&] (const BlockRows& rows) { kernels ().count_others (of_rows, rows); });
  return nodesWhere (graph.size (), [&] (std::uint32_t node) {
    return others[node] >= static_cast<float> (othersToChange (graph.row (node).size ()));
  });
}

/** Nodes that have one of \a nodes in their row. */
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
  return nodesWhere (graph.size (), [&] (std::uint32_t node) { return is_near[node] != 0; });
}

/** A set of nodes: neighbours of neighbours mostly coincide, and sorting them all would take most of the time. */
class NodeSet
{
public:
  /** \param[in] most upper bound on the insertions, repeated ones included */
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

  std::vector<std::uint32_t> table_; // size a power of two, at most half full
  std::vector<std::uint32_t> nodes_;
};

/** Fills the rows of nodes beside another sheet with neighbours of their neighbours on the same sheet. Of each row
  * the first sheet_row_length count: for long rows, time and memory would grow with the square of the length. */
class OwnSheetRows
{
public:
  /** \param[in] distance of the criterion, >= 0 */
  OwnSheetRows (const NeighborGraph& graph, const Positions& positions, const SheetCriterion& criterion, float distance)
  : graph_ (graph), positions_ (positions), criterion_ (criterion), distance_ (distance)
  {}

  /** \param[out] out sheet_row_length nodes */
  void
  write (std::uint32_t node, std::uint32_t* out)
  {
    const float sheet = sheetHeight (node);
    findAround (node, sheet);
    std::vector<Neighbor> own_sheet;
    for (const std::uint32_t other : found_.nodes ())
      if (other != node && !criterion_.isOther (node, other, evidence_to_drop, sheet))
        own_sheet.push_back ({squaredLength (positions_.difference (node, other)), graph_.order ()[other], other});
    const std::size_t size = std::min (own_sheet.size (), rowLength (node) - 1);
    const auto end = own_sheet.begin () + static_cast<std::ptrdiff_t> (size);
    std::nth_element (own_sheet.begin (), end, own_sheet.end ());
    std::sort (own_sheet.begin (), end);
    std::fill_n (out, sheet_row_length, node);
    for (std::size_t j = 0; j < size; ++j)
      out[j + 1] = own_sheet[j].slot;
  }

private:
  std::size_t
  rowLength (std::uint32_t node) const
  {
    return std::min (graph_.row (node).size (), sheet_row_length);
  }

  /** Height of a node's sheet over the node: by mean shift from the node to where most neighbours are. With heights
    * from the node itself, one between two sheets would get neighbours from both, and stay there. */
  float
  sheetHeight (std::uint32_t node) const
  {
    constexpr int steps = 5;
    constexpr float bandwidth = .6f; // as a share of the distance of the criterion
    const Row row = graph_.row (node);
    const float unit = std::max (bandwidth * distance_, std::numeric_limits<float>::min ());
    float sheet = 0;
    for (int step = 0; step < steps; ++step) {
      float sum = 0, weights = 0;
      for (std::size_t j = 1; j < rowLength (node); ++j)
        if (criterion_.areAlike (node, row[j])) {
          const float height = criterion_.height (node, row[j]), off = (height - sheet) / unit;
          const float weight = bell (off * off / 2);
          sum += weight * height;
          weights += weight;
        }
      sheet = weights > 0 ? sum / weights : sheet;
    }
    // Noise hardly puts a point farther off: it is on the rim of a plate.
    return std::abs (sheet) < distance_ ? sheet : 0;
  }

  /** A substitute for exp (-x), as in kernels/local_points.h, bit for bit the same everywhere. */
  static float
  bell (float x)
  {
    float power = std::max (1 - x / 16, 0.0f);
    for (int squares = 0; squares < 4; ++squares)
      power *= power;
    return power;
  }

  void
  findAround (std::uint32_t node, float sheet)
  {
    const Row row = graph_.row (node);
    std::size_t most = 0;
    for (std::size_t j = 0; j < rowLength (node); ++j)
      most += rowLength (row[j]);
    found_.clear (most);
    for (std::size_t j = 0; j < rowLength (node); ++j)
      if (j == 0 || !criterion_.isOther (node, row[j], evidence_to_drop, sheet))
        for (std::size_t t = 0; t < rowLength (row[j]); ++t)
          found_.insert (graph_.row (row[j])[t]);
  }

  const NeighborGraph& graph_;
  const Positions& positions_;
  const SheetCriterion& criterion_;
  float distance_;
  NodeSet found_;
};
} // namespace

// The row of a node is written from the rows of its neighbours and the normals of the nodes in these (2 hops). Unless
// given, a normal is elected twice. The second vote is among first-vote normals of neighbours (3); it takes place if a
// neighbour is beside another sheet, which depends on the first-vote normals around that (4). The first vote is among
// normals of neighbours, estimated from the rows of these (5).
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
  Vectors normals = oriented
                        ? *options.oriented_normals
                        : electNormals (*graph, positions, {options.distance, sheet_row_length}, nullptr, execution);
  const SheetCriterion criterion (positions, normals, options.distance, oriented);
  std::vector<std::uint32_t> nodes = nodesBesideOtherSheets (*graph, criterion, nullptr, execution);
  if (!oriented && !nodes.empty ()) {
    const std::vector<std::uint32_t> near = nodesNear (*graph, nodes, execution);
    normals = electAgain (*graph, positions, options.distance, normals, near, execution);
    nodes = nodesBesideOtherSheets (*graph, criterion, &near, execution);
  }
  if (nodes.empty ())
    return graph;
  std::vector<std::uint32_t> rows (nodes.size () * sheet_row_length);
  parallelFor (
      nodes.size (), execution,
      [&] (std::size_t begin, std::size_t end) {
        OwnSheetRows own_sheets (*graph, positions, criterion, options.distance);
        for (std::size_t i = begin; i < end; ++i)
          own_sheets.write (nodes[i], rows.data () + i * sheet_row_length);
      },
      64);
  return graph->withRows (nodes, rows, sheet_row_length);
}
} // namespace core
} // namespace pcl_normal_smoothing
