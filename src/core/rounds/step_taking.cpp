// SPDX-License-Identifier: BSD-3-Clause
#include "step_taking.h"

namespace pcl_normal_smoothing
{
namespace core
{
StepTaking::StepTaking (const Cloud& cloud, const RobustSmoothingOptions& options)
: cloud_ (cloud)
, options_ (options)
, schedule_ (scheduleOf (options))
, moved_ (cloud.graph.size (), 0.0f)
, weights_ (pairsBegin (cloud.graph, cloud.graph.blockCount ()))
{}

void
StepTaking::freeRisks ()
{
  Numbers ().swap (risks_);
  Numbers ().swap (averaged_);
}

void
StepTaking::take (int round, const NodeArrays& nodes, const Execution& execution, Vectors& steps)
{
  risks_.resize (2 * cloud_.graph.size ());
  averaged_.resize (2 * cloud_.graph.size ());
  const auto run = [&] (const auto& kernel, const auto& task) { runOnNearest (cloud_.graph, execution, kernel, task); };
  const RiskLimit limit = riskLimitOf (round);
  float* proposed = steps.data ()->data ();
  run (kernels ().step_risks, StepRisks {nodes, proposed, moved_.data (), limit, risks_.data ()});
  if (round == 0) // normals and positions change little later on
    run (kernels ().averaging_weights, AveragingWeights {nodes, options_.oriented, weights_.data ()});
  averageRisks (execution);
  float* moved = round == 0 ? nullptr : moved_.data ();
  run (kernels ().take_steps,
       StepsToTake {nodes, cloud_.start, proposed, risks_.data (), limit, options_.max_displacement, moved, proposed});
}

RiskLimit
StepTaking::riskLimitOf (int round)
{
  const float variance = options_.noise.sigma * options_.noise.sigma, covariance = schedule_.covariances[round];
  limit_factors_ =
      cloud_.fine_rows.scaledWhereWide (cloud_.variance_factors, schedule_.wide_covariances[round] / covariance);
  return {schedule_.tolerance * variance * covariance,
          cloud_.fine_rows.areAllFine () ? cloud_.variance_factors : limit_factors_.data ()};
}

void
StepTaking::averageRisks (const Execution& execution)
{
  for (int average = 0; average < schedule_.averages; ++average) {
    runOnNearest (cloud_.graph, execution, kernels ().average_risks,
                  RiskAverages {weights_.data (), risks_.data (), averaged_.data ()});
    risks_.swap (averaged_);
  }
}
} // namespace core
} // namespace pcl_normal_smoothing
