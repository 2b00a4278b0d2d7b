// SPDX-License-Identifier: BSD-3-Clause
#include "noise_sample.h"
#include "../search/hash_sample.h"
#include "../search/kd_tree.h"
#include "../search/node_blocks.h"

#include <algorithm>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
constexpr std::uint32_t row_length = noise_row_length;
constexpr std::array<std::size_t, 3> sizes = {8, 12, row_length}; // of the neighbourhoods

/** The rows of the nodes in a sample, one after another, each padded with the node itself. */
using SampleRows = std::vector<std::uint32_t>;

// In distances of the last point of a row: points nearer to each other are copies up to rounding, with the same noise.
constexpr float copy_distance = 1e-3f;

/** Copies the node and its nearest, up to row_length, leaving out copies of points already there.
  * \param[in] row ascending by distance
  * \param[out] begin room for row_length, padded with the node itself */
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
rowsOfGraph (const NeighborGraph& graph,
             const Positions& nodes,
             const std::vector<std::uint32_t>& sample,
             const Execution& execution)
{
  SampleRows rows (sample.size () * row_length);
  parallelFor (
      sample.size (), execution.silent (),
      [&] (std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          copyDistinct (nodes, graph.row (sample[i]), &rows[i * row_length]);
      },
      64);
  return rows;
}

/** Rows as a graph of all nodes would have them, which would take more time and memory. */
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

/** The rows of some nodes in the layout of a graph's block, with their own copy of the positions: those in the cloud
  * lie far apart in memory, and so would one value per node. */
class SampleBlock
{
public:
  /** Takes the rows from \a begin on; lanes beyond the last row repeat it. */
  SampleBlock (const Positions& nodes, const SampleRows& rows, std::size_t begin)
  : positions_ {Vectors (size), Vectors (size), nodes.unit}, neighbors_ (size)
  {
    for (std::uint32_t lane = 0; lane < lanes; ++lane) {
      const std::uint32_t* row = &rows[std::min ((begin + lane) * row_length, rows.size () - row_length)];
      for (std::uint32_t j = 0; j < row_length; ++j) {
        const std::uint32_t i = j * lanes + lane;
        positions_.base[i] = nodes.base[row[j]];
        positions_.offset[i] = nodes.offset[row[j]];
        neighbors_[i] = row[j] == row[0] ? lane : i; // the node itself beyond the end of the row
      }
    }
  }

  /** Residual variances of quadrics through the nearest \a count of every row. */
  std::array<float, block_size>
  variances (std::size_t count) const
  {
    std::array<float, lanes> of_lanes;
    kernels ().residual_variances ({nodeArrays (positions_), of_lanes.data ()}, {neighbors_.data (), count});
    return of_lanes;
  }

private:
  static constexpr std::uint32_t lanes = block_size, size = lanes * row_length;

  Positions positions_;
  std::vector<std::uint32_t> neighbors_;
};

/** Place and distance of a node, without variances. */
NoiseSample::Residuals
residualsAt (const Positions& nodes, const std::uint32_t* row)
{
  const std::uint32_t node = row[0], eighth = row[sizes[0] - 1];
  return {{}, eighth == node ? 0 : nodes.difference (node, eighth).norm (), nodes.base[node]};
}

NoiseSample
residualsOf (const Positions& nodes, const SampleRows& rows, const Execution& execution)
{
  NoiseSample sample;
  sample.of_nodes.resize (rows.size () / row_length);
  const auto read = [&] (std::size_t begin) {
    const SampleBlock block (nodes, rows, begin);
    const std::size_t end = std::min (begin + block_size, sample.of_nodes.size ());
    for (std::size_t s = begin; s < end; ++s)
      sample.of_nodes[s] = residualsAt (nodes, &rows[s * row_length]);
    for (std::size_t i = 0; i < sizes.size (); ++i) {
      const auto variances = block.variances (sizes[i]);
      for (std::size_t s = begin; s < end; ++s)
        sample.of_nodes[s].variances[i] = variances[s - begin];
    }
  };
  parallelFor ((sample.of_nodes.size () + block_size - 1) / block_size, execution,
               [&] (std::size_t begin, std::size_t end) {
                 for (std::size_t block = begin; block < end; ++block)
                   read (block * block_size);
               },
               8);
  return sample;
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
  constexpr float of_distance = 1e-3f; // sigma over the distance
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
  // A graph by radius, or of small neighbourhoods, has too short rows.
  const bool is_enough = graph.minRowLength () >= std::min<std::size_t> (row_length, graph.size ());
  const SampleRows rows =
      is_enough ? rowsOfGraph (graph, nodes, sample, execution) : searchedRows (graph, nodes, sample, execution);
  return residualsOf (nodes, rows, execution);
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
  NoiseSample residuals = residualsOf (nodes, rowsOfGraph (graph, nodes, with_rows, execution), execution);
  residuals.short_rows = sample.size () - with_rows.size ();
  return residuals;
}
} // namespace core
} // namespace pcl_normal_smoothing
