// SPDX-License-Identifier: BSD-3-Clause
#include "filter_fixture.h"

#include <pcl/search/kdtree.h>

namespace
{
using namespace test_support;
using namespace pcl_normal_smoothing;

/** What the filters of one point type have each for themselves. */
template <typename FilterT>
class OwnParameters : public FilterTest<FilterT>
{
protected:
  /** Expects another result once \a set is called, and the first one again after \a reset. */
  template <typename Set, typename Reset>
  void
  expectEffect (const Set& set, const Reset& reset)
  {
    FilterT filter;
    this->prepare (filter);
    reset (filter);
    const auto before = this->run (filter);
    set (filter);
    const auto changed = this->run (filter);
    bool differs = false;
    for (std::size_t i = 0; i < before.size (); ++i)
      differs = differs || !samePoint (before[i], changed[i]);
    EXPECT_TRUE (differs);
    reset (filter);
    expectSamePoints (this->run (filter), before);
  }

  void
  expectRefused (void (*set) (FilterT&), const std::string& value)
  {
    FilterT filter;
    this->prepare (filter);
    set (filter);
    this->expectError (filter, value);
  }
};

using Bilateral = BilateralNormalFilter<pcl::PointNormal>;
using Update = NormalGuidedPointUpdate<pcl::PointNormal>;
using Smoothing = NormalSmoothing<pcl::PointNormal>;

class BilateralParameters : public OwnParameters<Bilateral>
{};
class UpdateParameters : public OwnParameters<Update>
{};
class SmoothingParameters : public OwnParameters<Smoothing>
{};

TEST_F (BilateralParameters, EachHasItsEffect)
{
  const auto gaussian = [] (Bilateral& filter) {
    filter.setNormalWeight (NormalWeight::GAUSSIAN);
    filter.setSigmaS (0.3);
    filter.setMaxIterations (4);
    filter.setNormalsOriented (false);
  };
  expectEffect ([] (auto& filter) { filter.setSigmaS (0.5); }, gaussian);
  expectEffect ([] (auto& filter) { filter.setMaxIterations (2); }, gaussian);
  expectEffect ([] (auto& filter) { filter.setNormalsOriented (true); }, gaussian);
  expectEffect ([] (auto& filter) { filter.setNormalWeight (NormalWeight::MIXED); }, gaussian);
  expectEffect ([] (auto& filter) { filter.setThreshold (0.9); },
                [] (auto& filter) {
                  filter.setNormalWeight (NormalWeight::THRESHOLD);
                  filter.setThreshold (0.65);
                });
  expectEffect ([] (auto& filter) { filter.setMixedThreshold (MixedThreshold::RMS); },
                [] (auto& filter) {
                  filter.setNormalWeight (NormalWeight::MIXED);
                  filter.setMixedThreshold (MixedThreshold::PRINTED);
                });
}

TEST_F (BilateralParameters, NoIterationCopiesTheInput)
{
  Bilateral filter;
  prepare (filter);
  filter.setMaxIterations (0);
  const auto output = run (filter);
  for (std::size_t i = 0; i < output.size (); ++i)
    EXPECT_LT ((output[i].getNormalVector3fMap () - normals_[i].normalized ()).norm (), 1e-6) << "point " << i;
}

TEST_F (BilateralParameters, OutOfRangeTheyAreRefused)
{
  expectRefused ([] (auto& filter) { filter.setMaxIterations (-7); }, "-7");
  expectRefused ([] (auto& filter) { filter.setThreshold (1.5); }, "1.5");
  expectRefused ([] (auto& filter) { filter.setThreshold (-0.5); }, "-0.5");
}

TEST_F (BilateralParameters, InputNormalsComeFirstAndMayHaveACloudOfTheirOwn)
{
  Bilateral filter;
  prepare (filter);
  filter.setInputNormals (makeNormals (Vectors (300, Eigen::Vector3f::UnitX ())));
  for (const auto& point : run (filter))
    EXPECT_EQ (point.getNormalVector3fMap (), Eigen::Vector3f::UnitX ());

  BilateralNormalFilter<pcl::PointXYZ> without;
  without.setInputCloud (makeCloud<pcl::PointXYZ> (points_, normals_));
  without.setKSearch (10);
  NormalCloud normals = poisonedCloud<pcl::Normal> ();
  without.filterNormals (normals);
  EXPECT_TRUE (normals.empty ());
  EXPECT_TRUE (contains (without.getErrorMessage (), "setInputNormals"));
  without.setInputNormals (makeNormals (normals_));
  normals = poisonedCloud<pcl::Normal> ();
  without.filterNormals (normals);
  const auto expected = result ();
  ASSERT_EQ (normals.size (), expected.size ());
  for (std::size_t i = 0; i < normals.size (); ++i)
    EXPECT_EQ (normals[i].getNormalVector3fMap (), expected[i].getNormalVector3fMap ()) << "point " << i;

  // Into the points it cannot write them, and says so.
  pcl::PointCloud<pcl::PointXYZ> output = poisonedCloud<pcl::PointXYZ> ();
  without.filter (output);
  expectEmpty (output);
  EXPECT_TRUE (contains (without.getErrorMessage (), "filterNormals")) << without.getErrorMessage ();
}

TEST_F (UpdateParameters, EachHasItsEffect)
{
  const auto defaults = [] (Update& filter) {
    filter.setUpdateRule (UpdateRule::COMPENSATED);
    filter.setSigmaS (0.1);
    filter.setMaxIterations (4);
    filter.setNormalsOriented (false);
    filter.setMaxDisplacement (1);
    filter.setSearchInterval (0);
  };
  expectEffect ([] (auto& filter) { filter.setUpdateRule (UpdateRule::PAPER); }, defaults);
  expectEffect ([] (auto& filter) { filter.setSigmaS (0.5); }, defaults);
  expectEffect ([] (auto& filter) { filter.setMaxIterations (2); }, defaults);
  expectEffect ([] (auto& filter) { filter.setNormalsOriented (true); }, defaults);
  expectEffect ([] (auto& filter) { filter.setMaxDisplacement (0.01); }, defaults);
  expectEffect ([] (auto& filter) { filter.setSearchInterval (1); }, defaults);
}

TEST_F (UpdateParameters, NoPointGoesFartherThanTheMaximum)
{
  Update filter;
  prepare (filter);
  filter.setMaxIterations (5);
  filter.setMaxDisplacement (0.01);
  const auto output = run (filter);
  for (std::size_t i = 0; i < output.size (); ++i)
    EXPECT_LE ((output[i].getVector3fMap () - points_[i]).norm (), 0.01 * 1.0001) << "point " << i;
}

TEST_F (UpdateParameters, ASearchIntervalWorksWithEverySearch)
{
  Update filter;
  prepare (filter);
  filter.setMaxIterations (3);
  filter.setSearchInterval (1);
  const auto expected = run (filter);
  auto search = std::make_shared<pcl::search::KdTree<pcl::PointNormal>> ();
  filter.setSearchMethod (search);
  const auto of_search = run (filter);
  for (std::size_t i = 0; i < expected.size (); ++i) // the search sees positions in float
    EXPECT_LT ((of_search[i].getVector3fMap () - expected[i].getVector3fMap ()).norm (), 1e-5) << "point " << i;
  EXPECT_EQ (search->getInputCloud (), cloud_) << "the user's search must be left with the user's cloud";
}

TEST_F (UpdateParameters, OutOfRangeTheyAreRefused)
{
  expectRefused ([] (auto& filter) { filter.setMaxIterations (-7); }, "-7");
  expectRefused ([] (auto& filter) { filter.setSearchInterval (-2); }, "-2");
  expectRefused ([] (auto& filter) { filter.setMaxDisplacement (-0.5); }, "-0.5");
  expectRefused ([] (auto& filter) { filter.setMaxDisplacement (0); }, "is 0:");
}

TEST_F (SmoothingParameters, NulloptTakesBackWhatWasSet)
{
  expectEffect ([] (auto& filter) { filter.setNoiseSigma (0.3); },
                [] (auto& filter) { filter.setNoiseSigma (std::nullopt); });
  expectEffect ([] (auto& filter) { filter.setPointIterations (1); },
                [] (auto& filter) { filter.setPointIterations (std::nullopt); });
  expectEffect ([] (auto& filter) { filter.setNormalIterations (1); }, // it had chosen the chain
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
  Smoothing chain; // has no noise to know: what it says that it used may be set
  prepare (chain);
  chain.setNormalIterations (1);
  run (chain);
  chain.setNoiseSigma (chain.usedOptions ().rounds.noise.sigma);
  run (chain);
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
  prepare (by_hand); // DESIGN section 7
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
  for (std::size_t i = 0; i < output.size (); ++i) // between the stages normals are stored and normalised anew
    EXPECT_LT ((output[i].getVector3fMap () - expected[i].getVector3fMap ()).norm (), 1e-5) << "point " << i;
}
} // namespace
