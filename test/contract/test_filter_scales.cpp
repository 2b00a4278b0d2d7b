// SPDX-License-Identifier: BSD-3-Clause
#include "filter_fixture.h"

#include <cmath>

namespace
{
using namespace test_support;
using namespace pcl_normal_smoothing;

/** Clouds in units from 1e-30 to 1e30. */
template <typename FilterT>
class FilterScales : public FilterTest<FilterT>
{
protected:
  using Cloud = typename FilterScales::Cloud;

  /** The fixture's cloud in another unit. */
  typename FilterScales::CloudPtr
  scaledCloud (double scale) const
  {
    Vectors points;
    for (const auto& point : this->points_)
      points.push_back ((scale * point.template cast<double> ()).template cast<float> ());
    return makeCloud<typename FilterScales::Point> (points, this->normals_);
  }

  template <typename Set>
  Cloud
  resultAt (double scale, const Set& set) const
  {
    FilterT filter;
    this->prepare (filter, scaledCloud (scale), this->normals_);
    filter.setKSearch (10);
    set (filter);
    return this->run (filter);
  }

  /** \param[in] set (filter, scale) sets what the test needs besides k */
  template <typename Set>
  void
  expectTheSameBits (const Set& set) const
  {
    const Cloud expected = resultAt (1, [&] (FilterT& filter) { set (filter, 1.0); });
    for (const int exponent : {-110, -73, -20, 10, 73, 110}) {
      const double scale = std::ldexp (1.0, exponent);
      const Cloud output = resultAt (scale, [&] (FilterT& filter) { set (filter, scale); });
      ASSERT_EQ (output.size (), expected.size ());
      for (std::size_t i = 0; i < output.size (); ++i) {
        ASSERT_EQ (output[i].getVector3fMap (), static_cast<float> (scale) * expected[i].getVector3fMap ())
            << "point " << i << ", scale 2^" << exponent;
        if constexpr (FilterScales::has_normal) {
          ASSERT_EQ (output[i].getNormalVector3fMap (), expected[i].getNormalVector3fMap ())
              << "point " << i << ", scale 2^" << exponent;
        }
      }
    }
  }
};

TYPED_TEST_SUITE (FilterScales, OneOfEachFilter);

TYPED_TEST (FilterScales, TheResultIsTheSameBitForBitInUnitsThatDifferByPowersOfTwo)
{
  this->expectTheSameBits ([] (TypeParam&, double) {});
}

TYPED_TEST (FilterScales, SoItIsWithLengthsThatAreSet)
{
  this->expectTheSameBits ([] (TypeParam& filter, double scale) {
    filter.setKSearch (0);
    filter.setRadiusSearch (0.35 * scale);
    if constexpr (TestFixture::Traits::writes_points)
      filter.setMaxDisplacement (0.0625 * scale);
  });
  this->expectTheSameBits ([] (TypeParam& filter, double scale) { filter.setMaxNeighborDistance (0.25 * scale); });
}

TYPED_TEST (FilterScales, SoItIsWhereNeighboursAreSearchedAnew)
{
  this->expectTheSameBits ([] (TypeParam& filter, double) {
    if constexpr (TestFixture::Traits::writes_points)
      filter.setSearchInterval (1);
    else
      filter.setMaxIterations (3);
  });
}

TYPED_TEST (FilterScales, OtherUnitsDoNotChangeItMuch)
{
  const auto expected = this->resultAt (1, [] (TypeParam&) {});
  for (const double scale : {1e-30, 1e-22, 1e-9, 1e9, 1e22, 1e30}) {
    const auto output = this->resultAt (scale, [] (TypeParam&) {});
    for (std::size_t i = 0; i < output.size (); ++i) {
      const Eigen::Vector3d at = output[i].getVector3fMap ().template cast<double> () / scale;
      ASSERT_LT ((at - expected[i].getVector3fMap ().template cast<double> ()).norm (), 1e-4)
          << "point " << i << ", scale " << scale;
      if constexpr (TestFixture::has_normal) {
        ASSERT_LT ((output[i].getNormalVector3fMap () - expected[i].getNormalVector3fMap ()).norm (), 1e-3)
            << "point " << i << ", scale " << scale;
      }
    }
  }
}

TYPED_TEST (FilterScales, AFewPointsFarOffDoNotSpoilTheRest)
{
  const auto set = [] (TypeParam& filter) {
    if constexpr (TestFixture::Traits::writes_points)
      filter.setSearchInterval (1);
  };
  const auto expected = this->resultAt (1, set);
  const std::size_t size = this->points_.size ();
  for (const float far : {1e12f, 1e22f, 1e30f, 3e38f}) {
    Vectors points = this->points_, normals = this->normals_;
    for (std::size_t i = 0; i < 30; ++i) {
      points.push_back (far * this->points_[7 * i].normalized ());
      normals.push_back (Eigen::Vector3f::UnitZ ());
    }
    TypeParam filter;
    this->prepare (filter, makeCloud<typename TestFixture::Point> (points, normals), normals);
    filter.setKSearch (10);
    set (filter);
    const auto output = this->run (filter);
    ASSERT_EQ (output.size (), size + 30);
    for (std::size_t i = 0; i < output.size (); ++i)
      EXPECT_TRUE (output[i].getVector3fMap ().allFinite ()) << "point " << i << ", far " << far;
    for (std::size_t i = 0; i < size; ++i)
      EXPECT_LT ((output[i].getVector3fMap () - expected[i].getVector3fMap ()).norm (), 0.2)
          << "point " << i << ", far " << far;
  }
}

TYPED_TEST (FilterScales, ALengthThatFloatCannotHoldIsAnErrorThatNamesIt)
{
  const auto expectRefused = [this] (const auto& set) {
    for (const auto& [length, name] : {std::pair (1e-50, "1e-50"), std::pair (1e50, "1e+50")}) {
      TypeParam filter;
      this->prepare (filter);
      set (filter, length);
      this->expectError (filter, name);
    }
  };
  expectRefused ([] (TypeParam& filter, double length) {
    filter.setKSearch (0);
    filter.setRadiusSearch (length);
  });
  expectRefused ([] (TypeParam& filter, double length) { filter.setMaxNeighborDistance (length); });
  if constexpr (TestFixture::Traits::writes_points)
    expectRefused ([] (TypeParam& filter, double length) { filter.setMaxDisplacement (length); });
  if constexpr (TestFixture::Traits::estimates_normals) {
    expectRefused ([] (TypeParam& filter, double length) { filter.setNoiseSigma (length); });
    expectRefused ([] (TypeParam& filter, double length) { filter.setPointSpacing (length); });
    expectRefused ([] (TypeParam& filter, double length) { filter.setSheetDistance (length); });
  }
}

using Smoothing = NormalSmoothing<pcl::PointXYZ>;

class SmoothingScales : public FilterScales<Smoothing>
{};

TEST_F (SmoothingScales, EveryMethodWorksInEveryUnit)
{
  for (const NormalSource source : {NormalSource::PCA, NormalSource::WPCA, NormalSource::HOUGH})
    for (const UpdateRule rule : {UpdateRule::PAPER, UpdateRule::COMPENSATED}) {
      const auto set = [&] (Smoothing& filter) {
        filter.setNormalSource (source);
        filter.setUpdateRule (rule);
      };
      const auto expected = resultAt (1, set);
      for (const double scale : {1e-30, 1e-22, 1e22, 1e30}) {
        const auto output = resultAt (scale, set);
        double sum = 0; // the Hough transform draws other triples
        for (std::size_t i = 0; i < output.size (); ++i)
          sum += (output[i].getVector3fMap ().cast<double> () / scale - expected[i].getVector3fMap ().cast<double> ())
                     .norm ();
        EXPECT_LT (sum / static_cast<double> (output.size ()), source == NormalSource::HOUGH ? 0.02 : 1e-5)
            << "scale " << scale;
      }
    }
}

TEST_F (SmoothingScales, TheOptionsThatWereUsedAreInTheCloudsUnit)
{
  const auto used = [this] (double scale) {
    Smoothing filter;
    prepare (filter, scaledCloud (scale), normals_);
    run (filter);
    return filter.usedOptions ().rounds;
  };
  const auto expected = used (1);
  EXPECT_GT (expected.noise.sigma, 0);
  for (const int exponent : {-100, 100}) {
    const auto rounds = used (std::ldexp (1.0, exponent));
    EXPECT_EQ (rounds.noise.sigma, std::ldexp (expected.noise.sigma, exponent));
    EXPECT_EQ (rounds.noise.spacing, std::ldexp (expected.noise.spacing, exponent));
    EXPECT_EQ (rounds.sheet_distance, std::ldexp (expected.sheet_distance, exponent));
    EXPECT_EQ (rounds.max_displacement, std::ldexp (expected.max_displacement, exponent));
  }
}

TEST (UpdateScales, APointThatWouldLeaveTheRangeOfFloatIsAnError)
{
  const Shape ball = sphere (300, 1); // which the paper's update inflates
  float largest = 0;
  for (const auto& point : ball.points)
    largest = std::max (largest, point.lpNorm<Eigen::Infinity> ());
  for (const float most : {1e38f, std::numeric_limits<float>::max ()}) {
    Vectors points;
    for (const auto& point : ball.points)
      points.push_back (point / largest * most);
    NormalGuidedPointUpdate<pcl::PointXYZ> update;
    update.setInputCloud (makeCloud<pcl::PointXYZ> (points, ball.normals));
    update.setInputNormals (makeNormals (ball.normals));
    update.setKSearch (10);
    update.setUpdateRule (UpdateRule::PAPER);
    auto output = poisonedCloud<pcl::PointXYZ> ();
    update.filter (output);
    if (most < 2e38f) {
      EXPECT_EQ (update.getErrorMessage (), "");
      EXPECT_EQ (output.size (), points.size ());
      continue;
    }
    expectEmpty (output);
    EXPECT_TRUE (contains (update.getErrorMessage (), "another unit")) << update.getErrorMessage ();
  }
}
} // namespace
