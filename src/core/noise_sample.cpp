// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/hash_sample.h>
#include <pcl_normal_smoothing/core/kd_tree.h>
#include <pcl_normal_smoothing/core/node_blocks.h>
#include <pcl_normal_smoothing/core/noise_sample.h>

#include <algorithm>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
constexpr std::uint32_t row_length = noise_row_length;

/** The neighbourhoods of the nodes in a sample, one after the other, each filled up with the node itself. */
using SampleRows = std::vector<std::uint32_t>;

// Of the way to the last of a row: nearer to each other than that are copies but for rounding, which have one noise.
constexpr float copy_distance = 1e-3f;

/** The nearest row_length of a row, the node first, without copies of others among them.
  * \param[in] row ascending by distance
  * \param[out] begin room for row_length, filled up with the node itself */
template <typename NodeRow>
void
copyDistinct (const Positions& nodes, const NodeRow& row, std::uint32_t* begin)
{
  std::uint32_t* end = begin;
  const std::size_t last = std::min<std::size_t> (row.size (), row_length) - 1;
  const float least = copy_distance * copy_distance * squaredLength (nodes.difference (row[0], row[last]));
  const auto isCopy = [&] (std::uint32_t node) {
    return std::any_of (begin, end,
                        [&] (std::uint32_t other) { return squaredLength (nodes.difference (node, other)) < least; });
  };
  for (std::size_t j = 0; j <= last; ++j)
    if (!isCopy (row[j]))
      *end++ = row[j];
  std::fill (end, begin + row_length, row[0]);
}

SampleRows
rowsOfGraph (const NeighborGraph& graph, const Positions& nodes, const std::vector<std::uint32_t>& sample)
{
  SampleRows rows (sample.size () * row_length);
  for (std::size_t i = 0; i < sample.size (); ++i)
    copyDistinct (nodes, graph.row (sample[i]), &rows[i * row_length]);
  return rows;
}

/** As a graph of all would have them, which takes longer and more memory. */
SampleRows
searchedRows (const NeighborGraph& graph,
              const Positions& nodes,
              const std::vector<std::uint32_t>& sample,
              const Execution& execution)
{
  const KdTree tree (nodes, graph.order (), execution.silent ());
  SampleRows rows (sample.size () * row_length);
  parallelFor (
      sample.size (), execution,
      [&] (std::size_t begin, std::size_t end) {
        KdTree::Scratch scratch;
        std::vector<std::uint32_t> row;
        for (std::size_t i = begin; i < end; ++i) {
          const std::uint32_t node = sample[i];
          row.assign (1, node);
          for (const Neighbor& neighbor : tree.search (nodes.base[node], nodes.offset[node], {row_length}, scratch))
            if (tree.order ()[neighbor.slot] != node && row.size () != row_length)
              row.push_back (tree.order ()[neighbor.slot]);
          copyDistinct (nodes, row, &rows[i * row_length]);
        }
      },
      64);
  return rows;
}

/** The rows of 16 nodes side by side, as a graph keeps those of a block. */
std::vector<std::uint32_t>
blockOf (const SampleRows& rows, std::size_t begin)
{
  std::vector<std::uint32_t> block (row_length * NeighborGraph::block_size);
  for (std::size_t lane = 0; lane < NeighborGraph::block_size; ++lane) {
    const std::size_t first = std::min ((begin + lane) * row_length, rows.size () - row_length);
    for (std::size_t j = 0; j < row_length; ++j)
      block[j * NeighborGraph::block_size + lane] = rows[first + j];
  }
  return block;
}

NoiseSample
residualsOf (const Positions& nodes,
             const std::vector<std::uint32_t>& sample,
             const SampleRows& rows,
             const Execution& execution)
{
  constexpr std::array<std::size_t, 3> sizes = {8, 12, 16};
  std::array<Numbers, 3> of_nodes;
  for (auto& variances : of_nodes)
    variances.resize (nodes.size ());
  const NodeArrays arrays = nodeArrays (nodes, nodes.base);
  const std::size_t block_count = (sample.size () + NeighborGraph::block_size - 1) / NeighborGraph::block_size;
  parallelFor (
      block_count, execution,
      [&] (std::size_t begin, std::size_t end) {
        for (std::size_t block = begin; block < end; ++block) {
          const auto block_rows = blockOf (rows, block * NeighborGraph::block_size);
          for (std::size_t i = 0; i < sizes.size (); ++i)
            kernels ().residual_variances ({arrays, of_nodes[i].data ()}, {block_rows.data (), sizes[i]});
        }
      },
      8);

  NoiseSample residuals;
  for (std::size_t s = 0; s < sample.size (); ++s) {
    const std::uint32_t node = sample[s], eighth = rows[s * row_length + sizes[0] - 1];
    residuals.of_nodes.push_back ({{of_nodes[0][node], of_nodes[1][node], of_nodes[2][node]},
                                   eighth == node ? 0 : nodes.difference (node, eighth).norm (),
                                   nodes.base[node]});
  }
  return residuals;
}
} // namespace

void
NoiseSample::join (const NoiseSample& part)
{
  of_nodes.insert (of_nodes.end (), part.of_nodes.begin (), part.of_nodes.end ());
  short_rows += part.short_rows;
}

std::size_t
NoiseSample::dropPlanes ()
{
  constexpr float of_distance = 1e-3f; // sigma
  const auto isPlane = [] (const Residuals& residuals) {
    const float sigma = of_distance * residuals.distance;
    return residuals.variances[0] < sigma * sigma;
  };
  const auto end = std::remove_if (of_nodes.begin (), of_nodes.end (), isPlane);
  const auto dropped = static_cast<std::size_t> (of_nodes.end () - end);
  of_nodes.erase (end, of_nodes.end ());
  return dropped;
}

NoiseSample
sampleNoise (const NeighborGraph& graph, const Positions& nodes, const Execution& execution)
{
  const std::vector<std::uint32_t> sample = sampleNodes (nodes, noise_sample_size, execution);
  // A graph by radius, or of small neighbourhoods, does not show enough.
  const bool is_enough = graph.minRowLength () >= std::min<std::size_t> (row_length, graph.size ());
  return residualsOf (nodes, sample,
                      is_enough ? rowsOfGraph (graph, nodes, sample) : searchedRows (graph, nodes, sample, execution),
                      execution);
}

NoiseSample
sampleNoise (const NeighborGraph& graph,
             const Positions& nodes,
             const std::vector<std::uint32_t>& sample,
             std::uint64_t cloud_size,
             const Execution& execution)
{
  std::vector<std::uint32_t> with_rows;
  for (const std::uint32_t node : sample)
    if (graph.row (node).size () >= std::min<std::uint64_t> (row_length, cloud_size))
      with_rows.push_back (node);
  NoiseSample residuals = residualsOf (nodes, with_rows, rowsOfGraph (graph, nodes, with_rows), execution);
  residuals.short_rows = sample.size () - with_rows.size ();
  return residuals;
}
} // namespace core
} // namespace pcl_normal_smoothing
