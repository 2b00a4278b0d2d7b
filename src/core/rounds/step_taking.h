// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fine_rows.h"
#include "round_schedule.h"

#include "../search/node_blocks.h"

namespace pcl_normal_smoothing
{
namespace core
{
/** Runs a kernel on all blocks, each row cut to its max_row_length nearest. */
template <typename Kernel, typename Task>
void
runOnNearest (const NeighborGraph& graph, const Execution& execution, const Kernel& kernel, const Task& task)
{
  forEachBlock (graph, execution, [&] (const BlockRows& rows) {
    kernel (task, BlockRows {rows.neighbors, std::min (rows.length, max_row_length), rows.begin, rows.pairs_begin});
  });
}

/** Takes as much of the proposed steps as the risk allows, round by round: derived in doc/robust_smoothing.md. */
class StepTaking
{
public:
  /** What stays the same in all rounds. */
  struct Cloud
  {
    const NeighborGraph& graph;
    const float* start;            // offsets before the first round; null where all are zero
    const float* variance_factors; // of the noise, per node; null: 1
    const FineRows& fine_rows;
  };

  /** \param[in] options kept while this is used, like everything that \a cloud refers to */
  StepTaking (const Cloud& cloud, const RobustSmoothingOptions& options);

  /** Frees memory that is not needed until the next call of take. */
  void
  freeRisks ();

  /** \param[in] nodes positions before the steps, and normals
    * \param[in,out] steps offsets: on entry as proposed, on return as taken */
  void
  take (int round, const NodeArrays& nodes, const Execution& execution, Vectors& steps);

private:
  /** The result is valid until the next call. */
  RiskLimit
  riskLimitOf (int round);

  void
  averageRisks (const Execution& execution);

  Cloud cloud_;
  const RobustSmoothingOptions& options_;
  RoundSchedule schedule_;
  Numbers limit_factors_;
  Numbers moved_; // distance along the normals since the first round, which is the reference for the risk
  Numbers risks_; // two values per node
  Numbers averaged_;
  PaddedVector<std::uint8_t> weights_;
};
} // namespace core
} // namespace pcl_normal_smoothing
