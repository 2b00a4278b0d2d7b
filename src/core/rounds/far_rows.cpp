// SPDX-License-Identifier: BSD-3-Clause
#include "round_schedule.h"

#include "../search/node_blocks.h"
#include "far_rows.h"

#include <algorithm>

namespace pcl_normal_smoothing
{
namespace core
{
FarRows::FarRows (const NeighborGraph& graph, const NodeArrays& nodes, const Execution& execution)
: graph_ (graph), row_lengths_ (graph.size ()), ranks_ (graph.blockCount () * block_size * far_row_length)
{
  std::vector<const std::uint32_t*> block_rows (graph.blockCount ());
  for (std::size_t block = 0; block < graph.blockCount (); ++block)
    block_rows[block] = graph.blockRows (block);
  parallelFor (graph.size (), execution, [&] (std::size_t begin, std::size_t end) {
    for (std::size_t node = begin; node < end; ++node)
      row_lengths_[node] = static_cast<std::uint8_t> (std::min (graph.row (node).size (), max_row_length));
  });
  // The kernel may skip lanes beyond the last node.
  std::fill (ranks_.end () - static_cast<std::ptrdiff_t> (std::min (ranks_.size (), block_size * far_row_length)),
             ranks_.end (), std::uint8_t (0));
  const FarRowsStep step = {nodes, block_rows.data (), row_lengths_.data (), ranks_.data ()};
  forEachBlock (graph, execution, [&] (const BlockRows& rows) { kernels ().find_far_rows (step, rows); });
}

BlockRows
FarRows::ofBlock (const BlockRows& rows, Buffer& buffer) const
{
  const std::uint8_t* ranks = ranks_.data () + rows.neighbors[0] * far_row_length;
  std::uint32_t lengths[block_size];
  for (std::size_t lane = 0; lane < block_size; ++lane)
    lengths[lane] = row_lengths_[rows.neighbors[lane]];
  for (std::size_t slot = 0; slot < far_row_length; ++slot)
    for (std::size_t lane = 0; lane < block_size; ++lane) {
      const std::size_t seed = seedRank (slot, lengths[lane]);
      const std::uint32_t neighbor = rows.neighbors[seed * block_size + lane];
      const std::size_t i = slot * block_size + lane;
      buffer.neighbors[i] = graph_.blockRows (neighbor / block_size)[neighbor % block_size + ranks[i] * block_size];
    }
  return {buffer.neighbors, far_row_length};
}
} // namespace core
} // namespace pcl_normal_smoothing
