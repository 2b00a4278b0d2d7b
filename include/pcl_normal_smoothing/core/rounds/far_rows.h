// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/kernels.h>
#include <pcl_normal_smoothing/core/padded_allocator.h>
#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** Neighbourhoods twice as wide as those of a graph, of as many points as narrow ones have, without a search: in place of a neighbour j of i
  * stands that neighbour of j which lies nearest to where the way from i to j ends when it is gone twice. What is in no row, as the
  * points of another sheet, does not come in. */
class FarRows
{
public:
  /** \param[in] graph kept while this is used
    * \param[in] positions with offsets; not kept */
  FarRows (const NeighborGraph& graph, const Positions& positions, const Execution& execution);

  /** What the rows of a block are put into, with room for kernels that read a vector past the end. */
  struct alignas (64) Buffer
  {
    std::uint32_t neighbors[(far_row_length + 1) * NeighborGraph::block_size];
  };

  /** \param[in] rows of a block of the graph \return its far rows, in \a buffer */
  BlockRows
  ofBlock (const BlockRows& rows, Buffer& buffer) const;

private:
  const NeighborGraph& graph_;
  PaddedVector<std::uint8_t> sizes_; // of the rows of all nodes
  PaddedVector<std::uint8_t> ranks_; // of what stands there among the neighbour's neighbours: 0 is the neighbour
};
} // namespace core
} // namespace pcl_normal_smoothing
