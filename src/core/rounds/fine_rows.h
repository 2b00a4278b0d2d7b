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
/** Neighbourhoods of the fine rounds: the fine_k nearest where they are wider than the noise; else, mostly in dense
  * places, max_row_length, if the row has more than fine_k. */
class FineRows
{
public:
  /** Storage for the rows of a block. */
  struct alignas (64) Buffer
  {
    std::uint32_t neighbors[max_row_length * block_size];
  };

  /** All nodes use fine_k neighbours. \param[in] graph kept while this is used */
  explicit FineRows (const NeighborGraph& graph) : graph_ (graph) {}

  /** Computes the spacing around every node, from its row and those of its neighbours.
    * \param[in] graph kept while this is used
    * \param[in] positions of the nodes, before the first round
    * \param[in] sigma of the noise
    * \param[in] variance_factors of the noise, per node; empty: 1 */
  FineRows (const NeighborGraph& graph,
            const Positions& positions,
            float sigma,
            const Numbers& variance_factors,
            const Execution& execution);

  /** Whether no node uses max_row_length. */
  bool
  areAllFine () const
  {
    return is_wide_.empty ();
  }

  /** \param[in] rows of a block of the graph \return its rows in fine rounds, perhaps in \a buffer */
  BlockRows
  ofBlock (const BlockRows& rows, Buffer& buffer) const;

  /** \param[in] factors per node; null: 1
    * \return the factors, times \a wide_factor for nodes that use max_row_length; empty if none does */
  Numbers
  scaledWhereWide (const float* factors, float wide_factor) const;

private:
  const NeighborGraph& graph_;
  std::vector<std::uint8_t> is_wide_; // per node; empty: no node is
};
} // namespace core
} // namespace pcl_normal_smoothing
