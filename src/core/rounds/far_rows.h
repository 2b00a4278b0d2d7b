// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../kernels.h"
#include <pcl_normal_smoothing/core/padded_allocator.h>
#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** Neighbourhoods of 16 points, about twice as wide as those of a graph, found without a search. Each neighbour j of
  * i is replaced by the neighbour of j nearest to p_i + 2 (p_j - p_i), among the five whose rank in j's row is close
  * to that of j in i's row. Points that are in no row, such as those of another sheet, never occur. */
class FarRows
{
public:
  /** \param[in] graph kept while this is used
    * \param[in] nodes positions of the nodes; not kept, and their normals not read */
  FarRows (const NeighborGraph& graph, const NodeArrays& nodes, const Execution& execution);

  /** Storage for the rows of a block. */
  struct alignas (64) Buffer
  {
    std::uint32_t neighbors[far_row_length * block_size];
  };

  /** \param[in] rows of a block of the graph \return its far rows, in \a buffer */
  BlockRows
  ofBlock (const BlockRows& rows, Buffer& buffer) const;

private:
  const NeighborGraph& graph_;
  PaddedVector<std::uint8_t> row_lengths_; // per node, at most max_row_length
  // Rank of the far neighbour within the neighbour's row; 0 is the neighbour itself.
  PaddedVector<std::uint8_t> ranks_;
};
} // namespace core
} // namespace pcl_normal_smoothing
