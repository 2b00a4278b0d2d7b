// SPDX-License-Identifier: BSD-3-Clause
#include "fine_rows.h"
#include "ray_motion.h"
#include "step_taking.h"

#include "../search/node_blocks.h"
#include "far_rows.h"
#include <pcl_normal_smoothing/core/chain/normal_filter.h>
#include <pcl_normal_smoothing/core/error.h>
#include <pcl_normal_smoothing/core/rounds/robust_smoothing.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace pcl_normal_smoothing
{
namespace core
{
void
check (const RobustSmoothingOptions& options)
{
  if (!(options.noise.sigma >= 0) || !(options.noise.spacing >= 0))
    throw Error ("the noise's sigma is " + numberText (options.noise.sigma) + ", the spacing " +
                 numberText (options.noise.spacing) + ": give lengths of at least 0");
  if (options.count < 0 || options.count > max_rounds)
    throw Error ("the number of rounds is " + std::to_string (options.count) + ": give 0 to " +
                 std::to_string (max_rounds));
  if (!(options.sheet_distance >= 0))
    throw Error ("the sheet distance is " + numberText (options.sheet_distance) + ": give a length of at least 0");
  if (!(options.max_displacement > 0))
    throw Error ("the maximal displacement is " + numberText (options.max_displacement) + ": give a length above 0");
}

namespace
{
/** The rounds' state, and their steps in order. Every loop that reads what the previous loop wrote for neighbours
  * makes a result depend on nodes one hop farther off; roundsDepth counts these hops. */
class Rounds
{
public:
  Rounds (const NeighborGraph& graph,
          const RobustSmoothingOptions& options,
          const Execution& execution,
          MovingSurface& surface)
  : graph_ (graph)
  , options_ (options)
  , execution_ (execution)
  , progress_ (execution)
  , positions_ (surface.positions)
  , normals_ (surface.normals)
  , schedule_ (scheduleOf (options))
  , all_normals_ (haveAllNormals (normals_))
  , start_ (surface.start)
  , other_ (graph.size ())
  , variance_factors_ (core::varianceFactors (options.noise.field, positions_, execution))
  , fine_rows_ (fineRows ())
  , step_taking_ ({graph, this->start (), varianceFactors (), fine_rows_}, options)
  {}

  void
  run ()
  {
    for (int round = 0; round < options_.count; ++round) {
      progress_ = execution_.part (round, round, options_.count);
      is_fine_ = round < schedule_.fine_rounds;
      if (round >= schedule_.first_far_round)
        beginFar ();
      fitNormals (round);
      if (const float sigma_s = filteringSigma (options_, round); sigma_s > 0)
        filterFitted (sigma_s);
      proposeSteps ();
      far_.reset ();
      step_taking_.take (round, nodeArrays (positions_, normals_), progress_, other_);
      positions_.offset.swap (other_);
      execution_.report ((round + 1.0) / options_.count);
    }
    if (options_.count > 0)
      keepApart ();
    if (options_.along_rays)
      moveAlongRays (start_, normals_, options_.max_displacement, execution_.silent (), positions_);
  }

private:
  FineRows
  fineRows () const
  {
    if (schedule_.fine_rounds == 0)
      return FineRows (graph_);
    return FineRows (graph_, positions_, options_.noise.sigma, variance_factors_, execution_.silent ());
  }

  void
  beginFar ()
  {
    step_taking_.freeRisks (); // their memory is reused by the far rows
    far_.emplace (graph_, nodeArrays (positions_), execution_.silent ());
  }

  /** Calls \a body with the rows of every block, as the current round uses them. */
  template <typename Body>
  void
  forRowsOfRound (const Body& body)
  {
    forEachBlock (graph_, progress_, [&] (const BlockRows& rows) {
      FarRows::Buffer far;
      FineRows::Buffer fine;
      body (far_       ? far_->ofBlock (rows, far)
            : is_fine_ ? fine_rows_.ofBlock (rows, fine)
                       : BlockRows {rows.neighbors, std::min (rows.length, max_row_length)});
    });
  }

  void
  fitNormals (int round)
  {
    const bool first = round == 0;
    QuadricFitStep step {};
    step.nodes = nodeArrays (positions_, normals_);
    step.solves = schedule_.solves[round];
    step.turn_frame = first;
    step.by_normal = !first || options_.oriented;
    step.oriented = options_.oriented;
    step.residual_factor = residualFactor ();
    step.variance_factors = varianceFactors ();
    step.ridge = ridgeOf (options_);
    step.fitted = other_.data ()->data ();
    forRowsOfRound ([&] (const BlockRows& rows) { kernels ().fit_normals (step, rows); });
    normals_.swap (other_);
  }

  /** One bilateral-Gaussian pass over the normals. */
  void
  filterFitted (float sigma_s)
  {
    NormalFilterStep step {};
    step.nodes = nodeArrays (positions_, normals_);
    step.weight = NormalWeight::GAUSSIAN;
    step.normal_factor = 1 / (2 * sigma_s * sigma_s);
    step.oriented = options_.oriented;
    step.all_normals = all_normals_;
    step.filtered = other_.data ()->data ();
    forRowsOfRound ([&] (const BlockRows& rows) {
      std::uint16_t distance_weights[block_size * max_row_length];
      kernels ().distance_weights ({step.nodes, distance_weights}, rows);
      NormalFilterStep of_block = step;
      of_block.distance_weights = distance_weights;
      kernels ().filter_normals (of_block, rows);
    });
    normals_.swap (other_);
  }

  void
  proposeSteps ()
  {
    const float sq_bandwidth = is_fine_ ? schedule_.fine_bandwidth * schedule_.fine_bandwidth : 1;
    const Numbers reach_factors = is_fine_ ? fine_rows_.scaledWhereWide (nullptr, sq_bandwidth) : Numbers ();
    PointUpdateStep step {};
    step.nodes = nodeArrays (positions_, normals_);
    step.start = step.nodes.offset;
    step.kind = UpdateKind::ROBUST;
    step.reach_scale = 1 / sq_bandwidth;
    step.reach_factors = reach_factors.empty () ? nullptr : reach_factors.data ();
    step.normal_factor = 1 / (2 * schedule_.sigma_s * schedule_.sigma_s);
    step.residual_factor = residualFactor ();
    step.variance_factors = varianceFactors ();
    step.oriented = options_.oriented;
    step.all_normals = all_normals_;
    step.max_displacement = std::numeric_limits<float>::infinity ();
    step.moved = other_.data ()->data ();
    forRowsOfRound ([&] (const BlockRows& rows) { kernels ().update_points (step, rows); });
  }

  void
  keepApart ()
  {
    KeepApartStep step {};
    step.nodes = nodeArrays (positions_, normals_);
    step.start = start ();
    step.oriented = options_.oriented;
    step.max_displacement = options_.max_displacement;
    step.moved = other_.data ()->data ();
    progress_ = execution_.silent (); // the rounds have already reported the end
    runOnNearest (graph_, progress_, kernels ().keep_apart, step);
    positions_.offset.swap (other_);
  }

  /** 1 / (2 (2 sigma)^2); without noise, any point off the surface counts as far off. */
  float
  residualFactor () const
  {
    const float sigma = options_.noise.sigma;
    return 1 / std::max (8 * sigma * sigma, std::numeric_limits<float>::min () * 1e8f);
  }

  /** Null where all are zero. */
  const float*
  start () const
  {
    return start_.empty () ? nullptr : start_.data ()->data ();
  }

  /** Null if 1 everywhere. */
  const float*
  varianceFactors () const
  {
    return variance_factors_.empty () ? nullptr : variance_factors_.data ();
  }

  const NeighborGraph& graph_;
  const RobustSmoothingOptions& options_;
  const Execution& execution_;
  Execution progress_; // reports the same share during a whole round, so that progress never goes back
  Positions& positions_;
  Vectors& normals_;
  RoundSchedule schedule_;
  bool all_normals_;           // every node has a normal, now and later
  bool is_fine_ = false;       // whether the current round is fine
  std::optional<FarRows> far_; // in far rounds, until steps are proposed
  const Vectors& start_;       // as returned by startOf
  Vectors other_;              // output of the current stage: normals or offsets
  Numbers variance_factors_;   // empty: 1 everywhere
  FineRows fine_rows_;
  StepTaking step_taking_;
};
} // namespace

Vectors
startNormals (const NeighborGraph& graph, const Positions& positions, const Execution& execution, std::size_t k)
{
  Vectors normals (graph.size ());
  const StartNormals task {nodeArrays (positions), normals.data ()->data ()};
  forEachBlock (graph, execution, [&] (const BlockRows& rows) {
    kernels ().start_normals (task, {rows.neighbors, std::min (rows.length, k)});
  });
  return normals;
}

void
smoothRobustly (const NeighborGraph& graph,
                const RobustSmoothingOptions& options,
                const Execution& execution,
                MovingSurface& surface)
{
  if (graph.size () > 0)
    Rounds (graph, options, execution, surface).run ();
}
} // namespace core
} // namespace pcl_normal_smoothing
