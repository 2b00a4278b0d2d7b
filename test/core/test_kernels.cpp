// SPDX-License-Identifier: BSD-3-Clause
#include "kernels_fixture.h"

namespace
{
using namespace pcl_normal_smoothing::core;
using namespace test_support;
using pcl_normal_smoothing::NormalWeight;

constexpr NormalWeight all_weights[] = {NormalWeight::THRESHOLD, NormalWeight::GAUSSIAN, NormalWeight::MIXED};

TEST_P (KernelsTest, DistanceWeightsAreTheSameForEveryInstructionSet)
{
  const std::size_t last = graph_->blockCount () - 1;
  const std::size_t nodes_of_last = graph_->size () - block_size * last;
  expectAllTheSame ([&] (const Kernels& kernels) {
    std::vector<std::uint16_t> weights = distanceWeights (kernels);
    for (std::size_t i = graph_->blockBegin (last); i < weights.size (); ++i)
      if (i % block_size >= nodes_of_last)
        weights[i] = 0; // lanes without a node, which kernels may skip
    return weights;
  });
}

TEST_P (KernelsTest, NormalsAreTheSameForEveryInstructionSet)
{
  for (const NormalWeight weight : all_weights)
    for (const bool oriented : {false, true})
      expectAllTheSame ([&] (const Kernels& kernels) { return filtered (kernels, weight, oriented, false); });
}

TEST_P (KernelsTest, PositionsAreTheSameForEveryInstructionSet)
{
  for (const UpdateKind kind : {UpdateKind::PAPER, UpdateKind::COMPENSATED, UpdateKind::ROBUST})
    for (const float max_displacement : {infinity, 0.01f}) {
      PointUpdateStep step = updateStep (kind);
      step.max_displacement = max_displacement;
      expectAllTheSame ([&] (const Kernels& kernels) { return moved (kernels, step); });
    }
}

TEST_P (KernelsTest, PositionsByFactorsOfTheNodesAreTheSameForEveryInstructionSet)
{
  const Numbers reach_factors = factorsOfNodes (), variance_factors (reach_factors.rbegin (), reach_factors.rend ());
  for (const UpdateKind kind : {UpdateKind::PAPER, UpdateKind::COMPENSATED, UpdateKind::ROBUST})
    for (const bool oriented : {false, true}) {
      PointUpdateStep step = updateStep (kind);
      step.reach_scale = 0.7f;
      step.reach_factors = reach_factors.data ();
      step.variance_factors = variance_factors.data ();
      step.oriented = oriented;
      expectAllTheSame ([&] (const Kernels& kernels) { return moved (kernels, step); });
    }
}

TEST_P (KernelsTest, WhoseNodesAllHaveNormalsGivesTheSameWithoutLookingForThem)
{
  for (Eigen::Vector3f& normal : normals_)
    if (!normal.allFinite ())
      normal = Eigen::Vector3f::UnitX ();
  expectAllTheSame ([&] (const Kernels& kernels) {
    for (const NormalWeight weight : all_weights)
      expectSameBits (filtered (kernels, weight, false, true), filtered (kernels, weight, false, false), kernels.name);
    for (const UpdateKind kind : {UpdateKind::COMPENSATED, UpdateKind::ROBUST}) {
      PointUpdateStep of_all = updateStep (kind);
      of_all.all_normals = true;
      expectSameBits (moved (kernels, of_all), moved (kernels, updateStep (kind)), kernels.name);
    }
    PointUpdateStep of_paper = updateStep (UpdateKind::PAPER);
    of_paper.all_normals = true;
    return moved (kernels, of_paper);
  });
}

TEST_P (KernelsTest, SheetsAreTheSameForEveryInstructionSet)
{
  for (const float agreement : {0.0f, 2.0f})
    expectAllTheSame ([&] (const Kernels& kernels) {
      std::vector<float> elected = vectors (), others (nodes_.size (), -77);
      const NormalVoteStep vote {nodeArrays (nodes_, normals_), 200, agreement, elected.data ()};
      const OtherSheetCount task {nodeArrays (nodes_, normals_), 0.001f, 0.09f, 0.7f, true, others.data ()};
      forEachBlock (*graph_, Execution (1), [&] (const BlockRows& rows) {
        kernels.elect_normals (vote, rows);
        kernels.count_others (task, rows);
      });
      EXPECT_TRUE (graph_->minRowLength () < 4 || *std::max_element (others.begin (), others.end ()) > 0);
      elected.insert (elected.end (), others.begin (), others.end ());
      return elected;
    });
}

TEST_P (KernelsTest, SomeNodesGiveWhatAllOfThemGive)
{
  const auto elected = [&] (const auto& forBlocks) {
    std::vector<float> normals = vectors ();
    const NormalVoteStep vote {nodeArrays (nodes_, normals_), 200, 2, normals.data ()};
    forBlocks ([&] (const BlockRows& rows) { kernels ().elect_normals (vote, rows); });
    return normals;
  };
  const std::vector<float> expected = elected ([&] (const auto& body) { forEachBlock (*graph_, Execution (2), body); });
  std::vector<std::uint32_t> some;
  for (std::uint32_t node = 0; node < nodes_.size (); node += 3)
    some.push_back (node);
  const std::vector<float> actual =
      elected ([&] (const auto& body) { forEachBlockOf (*graph_, some, 1000, Execution (2), body); });
  std::vector<float> mixed = vectors ();
  for (const std::uint32_t node : some)
    std::copy_n (expected.begin () + 3 * node, 3, mixed.begin () + 3 * node);
  expectSameBits (actual, mixed, "some nodes");
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
      const Numbers factors = factorsOfNodes ();
      step.variance_factors = oriented ? factors.data () : nullptr;
      step.ridge = 0.003f;
      step.fitted = normals.data ();
      forEachBlock (*graph_, Execution (1), [&] (const BlockRows& rows) { kernels.fit_normals (step, rows); });
      return normals;
    });
}

TEST_P (KernelsTest, FourTimesTheVarianceIsTwiceTheNoise)
{
  const Numbers factors (nodes_.size (), 4.0f);
  const auto compute = [&] (const float* variance_factors, float residual_factor) {
    std::vector<float> normals = vectors (), moved = vectors ();
    QuadricFitStep fit {};
    fit.nodes = nodeArrays (nodes_, normals_);
    fit.solves = 2;
    fit.residual_factor = residual_factor;
    fit.variance_factors = variance_factors;
    fit.ridge = 0.003f;
    fit.fitted = normals.data ();
    PointUpdateStep update = updateStep (UpdateKind::ROBUST);
    update.residual_factor = residual_factor;
    update.variance_factors = variance_factors;
    update.moved = moved.data ();
    forEachBlock (*graph_, Execution (1), [&] (const BlockRows& rows) {
      kernels ().fit_normals (fit, rows);
      kernels ().update_points (update, rows);
    });
    normals.insert (normals.end (), moved.begin (), moved.end ());
    return normals;
  };
  expectSameBits (compute (factors.data (), 400), compute (nullptr, 100), kernels ().name);
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

TEST_P (KernelsTest, ProjectionsAreTheSameForEveryInstructionSet)
{
  expectAllTheSame ([this] (const Kernels& kernels) {
    std::vector<float> projected = vectors ();
    forEachBlock (*graph_, Execution (1), [&] (const BlockRows& rows) {
      kernels.project_points ({nodeArrays (nodes_, normals_), projected.data ()}, rows);
    });
    return projected;
  });
}

TEST_P (KernelsTest, StepsAreTheSameForEveryInstructionSet)
{
  for (const bool first_round : {true, false})
    expectAllTheSame ([&] (const Kernels& kernels) {
      std::vector<std::uint8_t> weights (pairsBegin (*graph_, graph_->blockCount ()));
      Numbers moved (nodes_.size (), .01f), risks (2 * nodes_.size ()), averaged (risks.size ());
      Vectors proposed = nodes_.base; // in place: no lane may read what another has taken
      const Numbers factors = factorsOfNodes ();
      const NodeArrays nodes = nodeArrays (nodes_, normals_);
      const RiskLimit limit {.3f, first_round ? nullptr : factors.data ()};
      float* steps = proposed.data ()->data ();
      const auto run = [&] (const auto& kernel, const auto& task) {
        forEachBlock (*graph_, Execution (1), [&] (const BlockRows& rows) { kernel (task, rows); });
      };
      run (kernels.step_risks, StepRisks {nodes, steps, moved.data (), limit, risks.data ()});
      run (kernels.averaging_weights, AveragingWeights {nodes, false, weights.data ()});
      run (kernels.average_risks, RiskAverages {weights.data (), risks.data (), averaged.data ()});
      run (kernels.take_steps, StepsToTake {nodes, nullptr, steps, averaged.data (), limit, .4f,
                                            first_round ? nullptr : moved.data (), steps});
      std::vector<float> result (moved.begin (), moved.end ());
      for (const auto& offset : proposed)
        result.insert (result.end (), offset.data (), offset.data () + 3);
      return result;
    });
}

TEST_P (KernelsTest, PointsAreKeptApartTheSameForEveryInstructionSet)
{
  const Vectors start = withNoise (Vectors (nodes_.size (), Eigen::Vector3f::Zero ()), 0.2, 124);
  for (const bool moved_before : {true, false})
    expectAllTheSame ([&] (const Kernels& kernels) {
      Vectors moved (nodes_.size ());
      KeepApartStep step {};
      step.nodes = nodeArrays (nodes_, normals_);
      step.start = moved_before ? start.data ()->data () : nullptr;
      step.max_displacement = .3f;
      step.moved = moved.data ()->data ();
      forEachBlock (*graph_, Execution (1), [&] (const BlockRows& rows) { kernels.keep_apart (step, rows); });
      EXPECT_TRUE (moved != nodes_.offset || !moved_before || nodes_.size () < 100);
      return std::vector<float> (moved.data ()->data (), moved.data ()->data () + 3 * moved.size ());
    });
}

TEST_P (KernelsTest, TheWayAlongTheNormalIsAddedUpFromTheSecondRoundOn)
{
  for (const bool first_round : {true, false}) {
    const Vectors proposed = withNoise (nodes_.offset, 0.02, 123);
    Vectors taken (proposed.size ());
    Numbers moved (nodes_.size (), .01f), risks (2 * nodes_.size (), 1);
    StepsToTake steps {};
    steps.nodes = nodeArrays (nodes_, normals_);
    steps.proposed = proposed.data ()->data ();
    steps.risks = risks.data ();
    steps.limit.usual = 10; // more than any risk, so that whole steps are taken
    steps.max_displacement = infinity;
    steps.moved = first_round ? nullptr : moved.data ();
    steps.taken = taken.data ()->data ();
    forEachBlock (*graph_, Execution (1), [&] (const BlockRows& rows) { kernels ().take_steps (steps, rows); });
    for (std::size_t i = 0; i < nodes_.size (); ++i) {
      const float way = (proposed[i] - nodes_.offset[i]).dot (normals_[i]);
      EXPECT_NEAR (moved[i], .01f + (first_round || std::isnan (way) ? 0 : way), 1e-6f) << "node " << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P (Graphs, KernelsTest, graphsForKernels ());
} // namespace
