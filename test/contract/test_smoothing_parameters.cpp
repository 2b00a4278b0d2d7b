// SPDX-License-Identifier: BSD-3-Clause
#include "own_parameters.h"

namespace
{
using namespace test_support;
using namespace pcl_normal_smoothing;

using Bilateral = BilateralNormalFilter<pcl::PointNormal>;
using Update = NormalGuidedPointUpdate<pcl::PointNormal>;
using Smoothing = NormalSmoothing<pcl::PointNormal>;

class SmoothingParameters : public OwnParameters<Smoothing>
{};

TEST_F (SmoothingParameters, NulloptTakesBackWhatWasSet)
{
  expectEffect ([] (auto& filter) { filter.setNoiseSigma (0.3); },
                [] (auto& filter) { filter.setNoiseSigma (std::nullopt); });
  expectEffect ([] (auto& filter) { filter.setPointIterations (1); },
                [] (auto& filter) { filter.setPointIterations (std::nullopt); });
  expectEffect ([] (auto& filter) { filter.setNormalIterations (1); }, // this had selected the chain
                [] (auto& filter) { filter.setNormalIterations (std::nullopt); });
}

TEST_F (SmoothingParameters, EachHasItsEffect)
{
  const auto fixed = [] (Smoothing& filter) {
    filter.setNormalSource (NormalSource::WPCA);
    filter.setNormalWeight (NormalWeight::GAUSSIAN);
    filter.setSigmaS (0.3);
    filter.setNormalIterations (3);
    filter.setUpdateRule (UpdateRule::COMPENSATED);
    filter.setUpdateSigmaS (0.1);
    filter.setPointIterations (3);
    filter.setMaxDisplacement (1);
    filter.setSearchInterval (0);
    filter.setSeed (0);
  };
  for (const NormalSource source : {NormalSource::PCA, NormalSource::HOUGH, NormalSource::INPUT})
    expectEffect ([=] (auto& filter) { filter.setNormalSource (source); }, fixed);
  expectEffect ([] (auto& filter) { filter.setNormalWeight (NormalWeight::THRESHOLD); }, fixed);
  expectEffect ([] (auto& filter) { filter.setSigmaS (0.5); }, fixed);
  expectEffect ([] (auto& filter) { filter.setNormalIterations (1); }, fixed);
  expectEffect ([] (auto& filter) { filter.setUpdateRule (UpdateRule::PAPER); }, fixed);
  expectEffect ([] (auto& filter) { filter.setUpdateSigmaS (0.4); }, fixed);
  expectEffect ([] (auto& filter) { filter.setPointIterations (1); }, fixed);
  expectEffect ([] (auto& filter) { filter.setMaxDisplacement (0.01); }, fixed);
  expectEffect ([] (auto& filter) { filter.setSearchInterval (1); }, fixed);
  const auto hough = [=] (Smoothing& filter) {
    fixed (filter);
    filter.setNormalSource (NormalSource::HOUGH);
  };
  expectEffect ([] (auto& filter) { filter.setSeed (9); }, hough);
}

TEST_F (SmoothingParameters, EstimatedNormalsAreNotOriented)
{
  for (const SmoothingPreset preset : {SmoothingPreset::DEFAULT, SmoothingPreset::FAST, SmoothingPreset::PAPER}) {
    Smoothing filter;
    prepare (filter);
    filter.setPreset (preset);
    filter.setNormalsOriented (true);
    expectError (filter, "NormalSource::INPUT");
    filter.setNormalSource (NormalSource::INPUT);
    EXPECT_EQ (run (filter).size (), 300u);
  }
}

TEST_F (SmoothingParameters, OutOfRangeTheyAreRefused)
{
  expectRefused ([] (auto& filter) { filter.setNoiseSigma (-5); }, "setNoiseSigma");
  expectRefused ([] (auto& filter) { filter.setNoiseSigma (-5); }, "-5:");
  expectRefused ([] (auto& filter) { filter.setNoiseSigma (nan_float); }, "nan");
  expectRefused ([] (auto& filter) { filter.setPointSpacing (-1); }, "-1:");
  expectRefused ([] (auto& filter) { filter.setSheetDistance (-1); }, "-1:");
  Smoothing chain; // the chain needs no noise: what it reports as used can be set
  prepare (chain);
  chain.setNormalIterations (1);
  run (chain);
  chain.setNoiseSigma (chain.usedOptions ().rounds.noise.sigma);
  run (chain);
}

TEST_F (SmoothingParameters, WhatWasEstimatedGivesTheSameResultWhenItIsSet)
{
  constexpr float spacing = 0.01f;
  // With two close sheets, the noise is estimated a second time, without the points of the other sheet.
  for (const Shape& shape : {planeGrid (60, spacing), parallelSheets (60, spacing, 1.5f * spacing)})
    for (const SmoothingPreset preset : {SmoothingPreset::DEFAULT, SmoothingPreset::FAST}) {
      const auto cloud = makeCloud<pcl::PointNormal> (withNormalNoise (shape, 0.2 * spacing, 1), shape.normals);
      Smoothing first, second;
      for (Smoothing* filter : {&first, &second}) {
        prepare (*filter, cloud, {});
        filter->setPreset (preset);
      }
      const Cloud expected = run (first);
      const core::RobustSmoothingOptions& used = first.usedOptions ().rounds;
      second.setNoiseSigma (used.noise.sigma);
      second.setPointSpacing (used.noise.spacing);
      second.setSheetDistance (used.sheet_distance);
      second.setMaxDisplacement (used.max_displacement);
      expectSamePoints (run (second), expected);
    }
}

TEST_F (SmoothingParameters, ExplicitSettersHoldOverAPresetInAnyOrder)
{
  Smoothing before, after;
  prepare (before);
  prepare (after);
  before.setPointIterations (1);
  before.setPreset (SmoothingPreset::PAPER);
  after.setPreset (SmoothingPreset::PAPER);
  after.setPointIterations (1);
  expectSamePoints (run (before), run (after));
}

TEST_F (SmoothingParameters, ThePaperPresetIsThePapers)
{
  Smoothing preset, by_hand;
  prepare (preset);
  preset.setKSearch (0);
  preset.setPreset (SmoothingPreset::PAPER);
  prepare (by_hand); // PGU7 in section III of the paper, with 5 normal and 7 point iterations
  by_hand.setKSearch (7);
  by_hand.setNormalSource (NormalSource::PCA);
  by_hand.setNormalWeight (NormalWeight::GAUSSIAN);
  by_hand.setSigmaS (0.3);
  by_hand.setNormalIterations (5);
  by_hand.setUpdateRule (UpdateRule::PAPER);
  by_hand.setUpdateSigmaS (1.0 / 3);
  by_hand.setPointIterations (7);
  expectSamePoints (run (preset), run (by_hand));
}

TEST_F (SmoothingParameters, IsTheChainOfItsStages)
{
  Smoothing whole;
  prepare (whole);
  whole.setNormalSource (NormalSource::INPUT);
  whole.setNormalWeight (NormalWeight::GAUSSIAN);
  whole.setSigmaS (0.4);
  whole.setNormalIterations (3);
  whole.setUpdateRule (UpdateRule::COMPENSATED);
  whole.setUpdateSigmaS (0.05);
  whole.setPointIterations (2);

  Bilateral filter;
  filter.setInputCloud (cloud_);
  filter.setKSearch (10);
  filter.setSigmaS (0.4);
  filter.setMaxIterations (3);
  const auto filtered = std::make_shared<Cloud> ();
  filter.filter (*filtered);
  Update update;
  update.setInputCloud (filtered);
  update.setKSearch (10);
  update.setSigmaS (0.05);
  update.setMaxIterations (2);
  Cloud expected;
  update.filter (expected);
  const Cloud output = run (whole);
  ASSERT_EQ (output.size (), expected.size ());
  for (std::size_t i = 0; i < output.size (); ++i) // between the stages, normals are stored and normalised again
    EXPECT_LT ((output[i].getVector3fMap () - expected[i].getVector3fMap ()).norm (), 1e-5) << "point " << i;
}
} // namespace
