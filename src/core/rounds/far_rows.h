// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../kernels.h"
#include <pcl_normal_smoothing/core/padded_allocator.h>
#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** Neighbourhoods about twice as wide as those of a graph, of 16 points, without a search. In place of a neighbour j of
  * i stands the neighbour of j that is nearest to p_i + 2 (p_j - p_i), among the five whose rank in j's row is about
  * that of j in i's row. What is in no row, as the points of another sheet, does not come in. */
class FarRows
{
public:
  /** \param[in] graph kept while this is used
    * \param[in] nodes where the nodes are; not kept, and their normals not read */
  FarRows (const NeighborGraph& graph, const NodeArrays& nodes, const Execution& execution);

  /** What the rows of a block are put into. */
  struct alignas (64) Buffer
  {
    std::uint32_t neighbors[far_row_length * block_size];
  };

  /** \param[in] rows of a block of the graph \return its far rows, in \a buffer */
  BlockRows
  ofBlock (const BlockRows& rows, Buffer& buffer) const;

private:
  const NeighborGraph& graph_;
  PaddedVector<std::uint8_t> row_lengths_; // of all nodes, max_row_length at most
  PaddedVector<std::uint8_t> ranks_;       // of what stands there among the neighbour's neighbours: 0 is the neighbour
};
} // namespace core
} // namespace pcl_normal_smoothing
