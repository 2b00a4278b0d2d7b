// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/node_blocks.h>
#include <pcl_normal_smoothing/core/robust_smoothing.h>
#include <pcl_normal_smoothing/core/sheet_separation.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
constexpr std::size_t start_k = 8;
constexpr std::size_t row_length = 32; // what smoothing in rounds looks at
constexpr float min_others = 3;
// Sheets are parallel; a neighbour across an edge is none of them.
constexpr float min_cosine = .7f;

/** How sure it must be that a neighbour lies on another sheet: normals are wrong by some slope. */
struct Evidence
{
  float distances; // of the sheet distance
  float slope;
};

// A row changes only where there is no doubt; then it had better lose a point too much.
constexpr Evidence to_change = {1, .3f};
constexpr Evidence to_drop = {.875f, .15f};

class SheetTest
{
public:
  SheetTest (const Positions& positions, const Vectors& normals, float distance, bool oriented)
  : positions_ (positions), normals_ (normals), sq_distance_ (distance * distance), oriented_ (oriented)
  {}

  bool
  isOther (std::uint32_t i, std::uint32_t j, const Evidence& evidence) const
  {
    const Eigen::Vector3f &own = normals_[i], &normal = normals_[j];
    const float cosine = own.dot (normal);
    if (oriented_ && cosine < 0)
      return true;
    const Eigen::Vector3f way = positions_.difference (i, j);
    const float height = .5f * (way.dot (own) + (cosine < 0 ? -way.dot (normal) : way.dot (normal)));
    return std::abs (cosine) > min_cosine &&
           height * height > evidence.distances * evidence.distances * sq_distance_ +
                                 evidence.slope * evidence.slope * squaredLength (way);
  }

  /** isOther of all neighbours of all nodes at once. \param[out] others how many of each are */
  OtherSheetTest
  ofAll (const Evidence& evidence, float* others) const
  {
    return {nodeArrays (positions_, normals_),
            evidence.distances * evidence.distances * sq_distance_,
            evidence.slope * evidence.slope,
            min_cosine,
            oriented_,
            others};
  }

private:
  const Positions& positions_;
  const Vectors& normals_;
  float sq_distance_;
  bool oriented_;
};

Vectors
electedNormals (const NeighborGraph& graph, const Positions& positions, float distance, const Execution& execution)
{
  const Vectors candidates = startNormals (graph, positions, execution, start_k);
  Vectors elected (graph.size ());
  NormalVoteStep step {};
  step.nodes = nodeArrays (positions, candidates);
  // Twice the noise, of which the sheet distance is four times.
  step.height_factor = 2 / std::max (distance * distance, std::numeric_limits<float>::min () * 1e8f);
  step.elected = elected.data ()->data ();
  forEachBlock (graph, execution, [&] (const BlockRows& rows) {
    kernels ().elect_normals (step, {rows.neighbors, std::min (rows.length, row_length)});
  });
  return elected;
}

std::vector<std::uint32_t>
nodesBesideOtherSheets (const NeighborGraph& graph, const SheetTest& test, const Execution& execution)
{
  Numbers others (graph.size ());
  const OtherSheetTest of_all = test.ofAll (to_change, others.data ());
  forEachBlock (graph, execution, [&] (const BlockRows& rows) {
    kernels ().count_others (of_all, {rows.neighbors, std::min (rows.length, row_length)});
  });
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t node = 0; node < graph.size (); ++node)
    if (others[node] >= min_others)
      nodes.push_back (node);
  return nodes;
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

/** Writes the row of \a node, of row_length, from the neighbours of its neighbours on its own sheet.
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
  std::size_t most = 0;
  for (std::size_t j = 0; j < row.size (); ++j)
    most += graph.blockLength (row[j] / NeighborGraph::block_size);
  found.clear (most);
  for (std::size_t j = 0; j < row.size (); ++j) {
    if (j > 0 && test.isOther (node, row[j], to_drop))
      continue;
    const Row further = graph.row (row[j]);
    for (std::size_t t = 0; t < further.size (); ++t)
      found.insert (further[t]);
  }

  std::vector<Neighbor> own_sheet;
  for (const std::uint32_t other : found.nodes ())
    if (other != node && !test.isOther (node, other, to_drop))
      own_sheet.push_back ({squaredLength (positions.difference (node, other)), graph.order ()[other], other});
  const std::size_t size = std::min ({own_sheet.size (), row.size () - 1, row_length - 1});
  const auto end = own_sheet.begin () + static_cast<std::ptrdiff_t> (size);
  std::nth_element (own_sheet.begin (), end, own_sheet.end ());
  std::sort (own_sheet.begin (), end);
  std::fill_n (out, row_length, node);
  for (std::size_t j = 0; j < size; ++j)
    out[j + 1] = own_sheet[j].slot;
}
} // namespace

// The row of a node is written from the rows of its neighbours and the normals of theirs. A normal that is not given is elected
// among those of the neighbours, which are estimated from their rows.
int
separationDepth (const SheetSeparationOptions& options)
{
  if (options.oriented_normals != nullptr)
    return 1;
  return std::isfinite (options.distance) ? 3 : -1;
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
  const Vectors normals =
      oriented ? *options.oriented_normals : electedNormals (*graph, positions, options.distance, execution);
  const SheetTest test (positions, normals, options.distance, oriented);
  const std::vector<std::uint32_t> nodes = nodesBesideOtherSheets (*graph, test, execution);
  if (nodes.empty ())
    return graph;
  std::vector<std::uint32_t> rows (nodes.size () * row_length);
  parallelFor (
      nodes.size (), execution,
      [&] (std::size_t begin, std::size_t end) {
        NodeSet found;
        for (std::size_t i = begin; i < end; ++i)
          writeOwnSheet (*graph, positions, test, nodes[i], found, rows.data () + i * row_length);
      },
      64);
  return graph->withRows (nodes, rows, row_length);
}
} // namespace core
} // namespace pcl_normal_smoothing
