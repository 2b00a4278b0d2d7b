// SPDX-License-Identifier: BSD-3-Clause
#include "graph_rows.h"
#include "shapes.h"

#include <core/search/node_blocks.h>

#include <gtest/gtest.h>

#include <limits>

namespace
{
using namespace pcl_normal_smoothing::core;
using namespace test_support;

/** A few points with normals along z. */
class StepControlTest : public testing::Test
{
protected:
  StepControlTest ()
  : graph_ (NeighborGraph::build (asPositions (planeGrid (2, 1).points), {3}, Execution (1)))
  , nodes_ (gather (asPositions (planeGrid (2, 1).points), graph_->order ()))
  , normals_ (graph_->size (), Eigen::Vector3f::UnitZ ())
  , proposed_ (graph_->size (), Eigen::Vector3f::UnitZ ())
  , risks_ (2 * graph_->size (), 0.0f)
  {}

  /** The share of the step that is taken, given the averages of both risks. */
  float
  shareFor (float product, float size, const RiskLimit& limit = {1, nullptr})
  {
    Vectors taken (graph_->size ());
    for (std::size_t i = 0; i < graph_->size (); ++i)
      risks_[2 * i] = product, risks_[2 * i + 1] = size;
    StepsToTake steps {};
    steps.nodes = nodeArrays (nodes_, normals_);
    steps.proposed = proposed_.data ()->data ();
    steps.risks = risks_.data ();
    steps.limit = limit;
    steps.max_displacement = std::numeric_limits<float>::infinity ();
    steps.taken = taken.data ()->data ();
    forEachBlock (*graph_, Execution (1), [&] (const BlockRows& rows) { kernels ().take_steps (steps, rows); });
    return taken[0].z ();
  }

  /** Computes the risks of points that moved by \a way along their normals since the first round. */
  void
  findRisks (float way)
  {
    const Numbers moved (graph_->size (), way);
    const StepRisks task {
        nodeArrays (nodes_, normals_), proposed_.data ()->data (), moved.data (), {1, nullptr}, risks_.data ()};
    forEachBlock (*graph_, Execution (1), [&] (const BlockRows& rows) { kernels ().step_risks (task, rows); });
  }

  NeighborGraph::ConstPtr graph_;
  Positions nodes_;
  Vectors normals_, proposed_;
  Numbers risks_;
};

TEST_F (StepControlTest, TheFourthPowerOfWhatTheRiskAllowsIsTaken)
{
  const float size = std::sqrt (2 / 1.57079633f); // mean square 2
  EXPECT_NEAR (shareFor (0, size), std::pow (0.5, 4), 1e-6);
  EXPECT_NEAR (shareFor (0.5f, size), std::pow (0.25, 4), 1e-6);
  EXPECT_NEAR (shareFor (-1, size), 1, 1e-6);
  EXPECT_EQ (shareFor (-5, size), 1);
  EXPECT_EQ (shareFor (1.5f, size), 0);
  EXPECT_EQ (shareFor (0, 0), 0);
}

TEST_F (StepControlTest, APointSaysNoMoreThanThreeLimits)
{
  const std::pair<float, float> products[] = {{0.5f, 0.5f}, {-2, -2}, {100, 3}, {-100, -3}};
  for (const auto& [moved, expected] : products) {
    findRisks (moved);
    EXPECT_EQ (risks_[0], expected);
    EXPECT_EQ (risks_[1], 1);
  }
}

TEST_F (StepControlTest, WhereTheNoiseIsLargeAStepMayCostMore)
{
  const Numbers factors (graph_->size (), 4.0f);
  const float expected = shareFor (3, 1, {4, nullptr});
  EXPECT_NE (shareFor (3, 1, {1, nullptr}), expected);
  EXPECT_EQ (shareFor (3, 1, {1, factors.data ()}), expected);
}
} // namespace
