// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "round_schedule.h"

#include "../kernels.h"
#include <pcl_normal_smoothing/core/padded_allocator.h>
#include <pcl_normal_smoothing/core/positions.h>
#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** The neighbourhoods of the fine rounds: the fine_k nearest where these reach out of the noise; max_row_length where
  * they would be lost in it, which is in dense places first. */
class FineRows
{
public:
  /** What the rows of a block are put into. */
  struct alignas (64) Buffer
  {
    std::uint32_t neighbors[max_row_length * block_size];
  };

  /** All nodes look at fine_k. \param[in] graph kept while this is used */
  explicit FineRows (const NeighborGraph& graph) : graph_ (graph) {}

  /** Asks how far apart points are around every node: its neighbours' rows are read.
    * \param[in] graph kept while this is used
    * \param[in] positions of the nodes, before the first round
    * \param[in] sigma of the noise
    * \param[in] variance_factors of the noise, of all nodes; empty: 1 */
  FineRows (const NeighborGraph& graph,
            const Positions& positions,
            float sigma,
            const Numbers& variance_factors,
            const Execution& execution);

  /** No node looks at max_row_length. */
  bool
  areAllFine () const
  {
    return is_wide_.empty ();
  }

  /** \param[in] rows of a block of the graph \return its rows in fine rounds, perhaps in \a buffer */
  BlockRows
  ofBlock (const BlockRows& rows, Buffer& buffer) const;

  /** \param[in] factors of all nodes; null: 1
    * \return the same, times \a wide_factor where a node looks at max_row_length; empty where no node does */
  Numbers
  scaledWhereWide (const float* factors, float wide_factor) const;

private:
  const NeighborGraph& graph_;
  std::vector<std::uint8_t> is_wide_; // of all nodes; empty: none is
};
} // namespace core
} // namespace pcl_normal_smoothing
