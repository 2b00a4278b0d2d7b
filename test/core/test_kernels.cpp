// SPDX-License-Identifier: BSD-3-Clause
#include "graph_rows.h"

#include <pcl_normal_smoothing/core/kernels.h>
#include <pcl_normal_smoothing/core/node_blocks.h>
#include <pcl_normal_smoothing/core/normal_filter.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace
{
using namespace pcl_normal_smoothing::core;
using namespace test_support;

constexpr float infinity = std::numeric_limits<float>::infinity ();
constexpr float nan_float = std::numeric_limits<float>::quiet_NaN ();

/** NaNs are equal here, bits count. */
template <typename Number>
void
expectSameBits (const std::vector<Number>& actual, const std::vector<Number>& expected, const std::string& kernels)
{
  ASSERT_EQ (actual.size (), expected.size ());
  for (std::size_t i = 0; i < expected.size (); ++i)
    ASSERT_EQ (std::memcmp (&actual[i], &expected[i], sizeof (Number)), 0)
        << kernels << ": number " << i << " is " << actual[i] << ", not " << expected[i];
}

/** Clouds whose last block is full or not, that have moved or not, rows of one length or of many, some nodes without a normal. */
class KernelsTest : public testing::TestWithParam<std::tuple<int, NeighborQuery>>
{
protected:
  KernelsTest ()
  {
    const Shape shape = torus (std::get<0> (GetParam ()), 1, 0.4);
    const Positions cloud = asPositions (withNoise (shape.points, 0.05, 120));
    graph_ = NeighborGraph::build (cloud, std::get<1> (GetParam ()), Execution (1));
    nodes_ = gather (cloud, graph_->order ());
    if (shape.points.size () % 2 == 1) // else they are all zero, and kernels do without
      nodes_.offset = withNoise (nodes_.offset, 0.02, 122);
    Vectors normals = withRandomSigns (shape.normals, 121);
    for (std::size_t i = 0; i < normals.size (); i += 11)
      normals[i].setConstant (nan_float);
    normals_ = byNode (normals, *graph_);
  }

  /** Three numbers a node, poisoned. */
  std::vector<float>
  vectors () const
  {
    return std::vector<float> (3 * nodes_.size (), -77);
  }

  std::vector<std::uint16_t>
  distanceWeights (const Kernels& kernels) const
  {
    std::vector<std::uint16_t> weights (graph_->blockBegin (graph_->blockCount ()), 77);
    forEachBlock (*graph_, Execution (1), [&] (const BlockRows& rows) {
      kernels.distance_weights ({nodeArrays (nodes_, normals_), weights.data ()}, rows);
    });
    return weights;
  }

  std::vector<float>
  filtered (const Kernels& kernels, int weight, bool oriented, bool all_normals) const
  {
    const std::vector<std::uint16_t> distance_weights = distanceWeights (kernels);
    std::vector<float> filtered = vectors ();
    NormalFilterStep step {};
    step.nodes = nodeArrays (nodes_, normals_);
    step.distance_weights = distance_weights.data ();
    step.weight = weight;
    step.threshold = 0.65f;
    step.normal_factor = 5.6f;
    step.rms = oriented;
    step.oriented = oriented;
    step.all_normals = all_normals;
    step.filtered = filtered.data ();
    forEachBlock (*graph_, Execution (1), [&] (const BlockRows& rows) { kernels.filter_normals (step, rows); });
    return filtered;
  }

  std::vector<float>
  moved (const Kernels& kernels, bool compensated, float max_displacement, bool all_normals) const
  {
    std::vector<float> moved = vectors ();
    PointUpdateStep step {};
    step.nodes = nodeArrays (nodes_, normals_);
    step.start = step.nodes.offset;
    step.compensated = compensated;
    step.normal_factor = 50;
    step.all_normals = all_normals;
    step.max_displacement = max_displacement;
    step.moved = moved.data ();
    forEachBlock (*graph_, Execution (1), [&] (const BlockRows& rows) { kernels.update_points (step, rows); });
    return moved;
  }

  template <typename Compute>
  static void
  expectAllTheSame (const Compute& compute)
  {
    std::size_t count = 0;
    const Kernels* const* all = allKernels (count);
    ASSERT_GT (count, 0u);
    for (std::size_t i = 0; i + 1 < count; ++i)
      expectSameBits (compute (*all[i]), compute (*all[count - 1]), all[i]->name);
  }

  NeighborGraph::Ptr graph_;
  Positions nodes_;
  Vectors normals_;
};

TEST_P (KernelsTest, DistanceWeightsAreTheSameForEveryInstructionSet)
{
  const std::size_t last = graph_->blockCount () - 1;
  const std::size_t nodes_of_last = graph_->size () - NeighborGraph::block_size * last;
  expectAllTheSame ([&] (const Kernels& kernels) {
    std::vector<std::uint16_t> weights = distanceWeights (kernels);
    for (std::size_t i = graph_->blockBegin (last); i < weights.size (); ++i)
      if (i % NeighborGraph::block_size >= nodes_of_last)
        weights[i] = 0; // a lane without a node of its own: kernels may leave it out
    return weights;
  });
}

TEST_P (KernelsTest, NormalsAreTheSameForEveryInstructionSet)
{
  for (const int weight : {0, 1, 2})
    for (const bool oriented : {false, true})
      expectAllTheSame ([&] (const Kernels& kernels) { return filtered (kernels, weight, oriented, false); });
}

TEST_P (KernelsTest, PositionsAreTheSameForEveryInstructionSet)
{
  for (const bool compensated : {false, true})
    for (const float max_displacement : {infinity, 0.01f})
      expectAllTheSame ([&] (const Kernels& kernels) { return moved (kernels, compensated, max_displacement, false); });
}

TEST_P (KernelsTest, WhoseNodesAllHaveNormalsGivesTheSameWithoutLookingForThem)
{
  for (Eigen::Vector3f& normal : normals_)
    if (!normal.allFinite ())
      normal = Eigen::Vector3f::UnitX ();
  expectAllTheSame ([&] (const Kernels& kernels) {
    for (const int weight : {0, 1, 2})
      expectSameBits (filtered (kernels, weight, false, true), filtered (kernels, weight, false, false), kernels.name);
    expectSameBits (moved (kernels, true, infinity, true), moved (kernels, true, infinity, false), kernels.name);
    return moved (kernels, false, infinity, true);
  });
}

TEST_P (KernelsTest, SheetsAreTheSameForEveryInstructionSet)
{
  expectAllTheSame ([this] (const Kernels& kernels) {
    std::vector<float> elected = vectors (), others (nodes_.size (), -77);
    const NormalVoteStep vote {nodeArrays (nodes_, normals_), 200, elected.data ()};
    const OtherSheetTest test {nodeArrays (nodes_, normals_), 0.001f, 0.09f, 0.7f, true, others.data ()};
    forEachBlock (*graph_, Execution (1), [&] (const BlockRows& rows) {
      kernels.elect_normals (vote, rows);
      kernels.count_others (test, rows);
    });
    EXPECT_TRUE (graph_->minRowLength () < 4 || *std::max_element (others.begin (), others.end ()) > 0);
    elected.insert (elected.end (), others.begin (), others.end ());
    return elected;
  });
}

TEST_P (KernelsTest, EstimatedNormalsAreTheSameForEveryInstructionSet)
{
  expectAllTheSame ([this] (const Kernels& kernels) {
    std::vector<float> normals = vectors ();
    forEachBlock (*graph_, Execution (1), [&] (const BlockRows& rows) {
      kernels.start_normals ({nodeArrays (nodes_, normals_), normals.data ()}, rows);
    });
    return normals;
  });
  for (const bool oriented : {false, true})
    expectAllTheSame ([&] (const Kernels& kernels) {
      std::vector<float> normals = vectors ();
      QuadricFitStep step {};
      step.nodes = nodeArrays (nodes_, normals_);
      step.solves = 3;
      step.turn_frame = !oriented;
      step.by_normal = step.oriented = oriented;
      step.residual_factor = 100;
      step.ridge = 0.003f;
      step.fitted = normals.data ();
      forEachBlock (*graph_, Execution (1), [&] (const BlockRows& rows) { kernels.fit_normals (step, rows); });
      return normals;
    });
}

TEST_P (KernelsTest, ResidualsAreTheSameForEveryInstructionSet)
{
  expectAllTheSame ([this] (const Kernels& kernels) {
    std::vector<float> variances (nodes_.size (), -77);
    forEachBlock (*graph_, Execution (1), [&] (const BlockRows& rows) {
      kernels.residual_variances ({nodeArrays (nodes_, normals_), variances.data ()}, rows);
    });
    return variances;
  });
}

TEST_P (KernelsTest, StepsAreTheSameForEveryInstructionSet)
{
  for (const bool first_round : {true, false})
    expectAllTheSame ([&] (const Kernels& kernels) {
      std::vector<std::uint8_t> weights (pairsBegin (*graph_, graph_->blockCount ()));
      Numbers moved (nodes_.size (), .01f), risks (2 * nodes_.size ()), averaged (risks.size ());
      Vectors proposed = nodes_.base; // in place: no lane may meet what another has taken
      StepControl control {};
      control.nodes = nodeArrays (nodes_, normals_);
      control.proposed = control.taken = proposed.data ()->data ();
      control.moved = moved.data ();
      control.first_round = first_round;
      control.weights = weights.data ();
      control.risks = risks.data ();
      control.averaged = averaged.data ();
      control.gain = .3f;
      control.max_displacement = .4f;
      for (const auto kernel : {kernels.step_risks, kernels.averaging_weights, kernels.average_risks})
        forEachBlock (*graph_, Execution (1), [&] (const BlockRows& rows) { kernel (control, rows); });
      control.risks = averaged.data ();
      forEachBlock (*graph_, Execution (1), [&] (const BlockRows& rows) { kernels.take_steps (control, rows); });
      std::vector<float> result (moved.begin (), moved.end ());
      for (const auto& offset : proposed)
        result.insert (result.end (), offset.data (), offset.data () + 3);
      return result;
    });
}

TEST_P (KernelsTest, TheWayAlongTheNormalIsAddedUpFromTheSecondRoundOn)
{
  for (const bool first_round : {true, false}) {
    const Vectors proposed = withNoise (nodes_.offset, 0.02, 123);
    Vectors taken (proposed.size ());
    Numbers moved (nodes_.size (), .01f), risks (2 * nodes_.size (), 1);
    StepControl control {};
    control.nodes = nodeArrays (nodes_, normals_);
    control.proposed = proposed.data ()->data ();
    control.taken = taken.data ()->data ();
    control.moved = moved.data ();
    control.first_round = first_round;
    control.risks = risks.data ();
    control.gain = 10; // more than any risk: whole steps
    control.max_displacement = infinity;
    forEachBlock (*graph_, Execution (1), [&] (const BlockRows& rows) { kernels ().take_steps (control, rows); });
    for (std::size_t i = 0; i < nodes_.size (); ++i) {
      const float way = (proposed[i] - nodes_.offset[i]).dot (normals_[i]);
      EXPECT_NEAR (moved[i], .01f + (first_round || std::isnan (way) ? 0 : way), 1e-6f) << "node " << i;
    }
  }
}

TEST_P (KernelsTest, VotesGoToTheBinOfTheirNormal)
{
  const float rotation[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const float band_cosine[] = {0.9f, 0.5f, 0.2f}, band_begin[] = {0, 1, 7, 17}; // the last band goes on to the equator
  for (std::uint32_t round = 0; round < 20; ++round) {
    std::uint32_t triples[3][16];
    for (std::uint32_t i = 0; i < 16; ++i)
      for (std::uint32_t corner = 0; corner < 3; ++corner)
        triples[corner][i] = static_cast<std::uint32_t> ((7 * i + (5 + round) * corner + 31 * round) % nodes_.size ());
    float normals[3][16];
    std::int32_t bins[16];
    kernels ().vote_planes (
        {nodes_.base.data ()->data (), triples, rotation, band_cosine, band_begin, 3, normals, bins});
    for (std::size_t i = 0; i < 16; ++i) {
      if (bins[i] < 0)
        continue;
      const double turn = std::atan2 (normals[1][i], normals[0][i]) / (2 * 3.14159265358979) + 1;
      const int band = (normals[2][i] < 0.9f) + (normals[2][i] < 0.5f);
      const double column = (turn - std::floor (turn)) * static_cast<double> (band_begin[band + 1] - band_begin[band]);
      if (std::abs (column - std::round (column)) < 0.05) // between two
        continue;
      EXPECT_EQ (bins[i], static_cast<int> (band_begin[band]) + static_cast<int> (column)) << "normal " << i;
    }
  }
}

TEST_P (KernelsTest, VotesOfPlanesAreTheSameForEveryInstructionSet)
{
  expectAllTheSame ([this] (const Kernels& kernels) {
    const float rotation[3][3] = {{0.36f, 0.48f, -0.8f}, {-0.8f, 0.6f, 0}, {0.48f, 0.64f, 0.6f}};
    const float band_cosine[] = {0.9f, 0.5f, 0}, band_begin[] = {0, 1, 7, 17};
    std::uint32_t triples[3][16];
    for (std::uint32_t i = 0; i < 16; ++i) // the last is of two points alone
      for (std::uint32_t corner = 0; corner < 3; ++corner)
        triples[corner][i] = i == 15 ? corner % 2 : static_cast<std::uint32_t> ((7 * i + 5 * corner) % nodes_.size ());
    float normals[3][16];
    std::int32_t bins[16];
    kernels.vote_planes ({nodes_.base.data ()->data (), triples, rotation, band_cosine, band_begin, 3, normals, bins});
    EXPECT_EQ (bins[15], -1);
    EXPECT_LT (*std::max_element (bins, bins + 16), 17);
    std::vector<float> result (bins, bins + 16);
    for (const auto& coordinates : normals)
      result.insert (result.end (), coordinates, coordinates + 16);
    return result;
  });
}

INSTANTIATE_TEST_SUITE_P (Graphs,
                          KernelsTest,
                          testing::Combine (testing::Values (3, 16, 333, 1000),
                                            testing::Values (NeighborQuery {3, infinity},
                                                             NeighborQuery {12, infinity},
                                                             NeighborQuery {0, 0.15f})));
} // namespace
