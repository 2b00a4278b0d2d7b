// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fine_rows.h"
#include "round_schedule.h"

#include "../search/node_blocks.h"

namespace pcl_normal_smoothing
{
namespace core
{
/** Runs a kernel on all blocks, with the max_row_length nearest of every row. */
template <typename Kernel, typename Task>
void
runOnNearest (const NeighborGraph& graph, const Execution& execution, const Kernel& kernel, const Task& task)
{
  forEachBlock (graph, execution, [&] (const BlockRows& rows) {
    kernel (task, BlockRows {rows.neighbors, std::min (rows.length, max_row_length), rows.begin, rows.pairs_begin});
  });
}

/** Takes as much of the proposed steps as the risk allows, round after round: doc/robust_smoothing.md derives it. */
class StepTaking
{
public:
  /** What does not change from round to round. */
  struct Cloud
  {
    const NeighborGraph& graph;
    const float* start;            // offsets before the first round; null where all are zero
    const float* variance_factors; // of the noise, of all nodes; null: 1
    const FineRows& fine_rows;
  };

  /** \param[in] options kept, as what \a cloud refers to, while this is used */
  StepTaking (const Cloud& cloud, const RobustSmoothingOptions& options);

  /** Gives back the memory that is not needed until the next steps are taken. */
  void
  freeRisks ();

  /** \param[in] nodes with their normals, before the steps
    * \param[in,out] steps proposed; on return taken: offsets */
  void
  take (int round, const NodeArrays& nodes, const Execution& execution, Vectors& steps);

private:
  /** Valid until the next. */
  StepGain
  gainOf (int round);

  void
  averageRisks (const Execution& execution);

  Cloud cloud_;
  const RobustSmoothingOptions& options_;
  RoundSchedule schedule_;
  Numbers gain_factors_;
  Numbers moved_; // along the normals since the first round, from where the risk is measured
  Numbers risks_; // two a node
  Numbers averaged_;
  PaddedVector<std::uint8_t> weights_;
};
} // namespace core
} // namespace pcl_normal_smoothing
