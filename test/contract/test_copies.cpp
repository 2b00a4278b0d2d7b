// SPDX-License-Identifier: BSD-3-Clause
#include "clouds.h"
#include "searches.h"

#include <pcl_normal_smoothing/bilateral_normal_filter.h>
#include <pcl_normal_smoothing/normal_smoothing.h>
#include <pcl_normal_smoothing/surface_noise_estimation.h>

namespace
{
using namespace pcl_normal_smoothing;
using namespace test_support;
using Cloud = pcl::PointCloud<pcl::PointNormal>;

constexpr double sigma = 0.01;

/** A noisy sphere with normals: alone, and joined with four copies, of which two have inward normals. */
class CopiesTest : public testing::Test
{
protected:
  CopiesTest ()
  {
    const Shape shape = sphere (3000, 1);
    single_ = makeCloud<pcl::PointNormal> (withNoise (shape.points, sigma, 60), shape.normals);
    joined_ = pcl::make_shared<Cloud> (*single_);
    for (int copy = 0; copy < 4; ++copy)
      for (pcl::PointNormal point : *single_) {
        point.getNormalVector3fMap () *= copy < 2 ? 1 : -1;
        joined_->push_back (point);
      }
  }

  static Cloud
  smoothed (const Cloud::ConstPtr& cloud, const std::function<void (NormalSmoothing<pcl::PointNormal>&)>& set)
  {
    NormalSmoothing<pcl::PointNormal> smoothing;
    set (smoothing);
    smoothing.setInputCloud (cloud);
    Cloud result;
    smoothing.filter (result);
    EXPECT_EQ (smoothing.getErrorMessage (), "");
    EXPECT_EQ (result.size (), cloud->size ());
    return result;
  }

  /** Sets everything that is estimated from a sample, as these estimates differ a little if there are copies. */
  static void
  setNoise (NormalSmoothing<pcl::PointNormal>& smoothing)
  {
    smoothing.setNoiseSigma (sigma);
    smoothing.setPointSpacing (0.06);
    smoothing.setSheetDistance (std::numeric_limits<double>::infinity ());
  }

  static Eigen::Vector3f
  displacement (const Cloud& cloud, const Cloud& result, std::size_t i)
  {
    return result[i].getVector3fMap () - cloud[i].getVector3fMap ();
  }

  Cloud::Ptr single_, joined_;
};

TEST_F (CopiesTest, GetWhatTheirOriginalGetsInACloudWithoutThem)
{
  for (const SmoothingPreset preset : {SmoothingPreset::DEFAULT, SmoothingPreset::FAST}) {
    const auto set = [=] (NormalSmoothing<pcl::PointNormal>& smoothing) {
      smoothing.setPreset (preset);
      setNoise (smoothing);
    };
    const Cloud alone = smoothed (single_, set), joined = smoothed (joined_, set);
    double moved = 0;
    for (std::size_t i = 0; i < joined.size (); ++i) {
      const std::size_t original = i % single_->size ();
      ASSERT_EQ (joined[i].getVector3fMap (), alone[original].getVector3fMap ()) << "point " << i;
      ASSERT_EQ (joined[i].getNormalVector3fMap (), alone[original].getNormalVector3fMap ()) << "point " << i;
      moved += displacement (*joined_, joined, i).norm ();
    }
    EXPECT_GT (moved / static_cast<double> (joined.size ()), 0.3 * sigma);
  }
}

TEST_F (CopiesTest, KeepTheSideOfTheirOwnNormal)
{
  const auto set = [] (NormalSmoothing<pcl::PointNormal>& smoothing) {
    smoothing.setNormalSource (NormalSource::INPUT);
    setNoise (smoothing);
  };
  const Cloud alone = smoothed (single_, set), joined = smoothed (joined_, set);
  for (std::size_t i = 0; i < joined.size (); ++i) {
    const float side = i / single_->size () < 3 ? 1 : -1;
    const Eigen::Vector3f normal = side * alone[i % single_->size ()].getNormalVector3fMap ();
    ASSERT_EQ (joined[i].getVector3fMap (), alone[i % single_->size ()].getVector3fMap ()) << "point " << i;
    ASSERT_EQ (joined[i].getNormalVector3fMap (), normal) << "point " << i;
  }
}

TEST_F (CopiesTest, OfEverySearchMoveTogether)
{
  auto searches = userSearches<pcl::PointNormal> ();
  searches.push_back (nullptr); // the module's own search
  for (const auto& search : searches) {
    const auto set = [&] (NormalSmoothing<pcl::PointNormal>& smoothing) {
      smoothing.setSearchMethod (search);
      smoothing.setKSearch (search ? 160 : 32);
    };
    const Cloud joined = smoothed (joined_, set);
    double error = 0, before = 0;
    for (std::size_t i = 0; i < joined.size (); ++i) {
      ASSERT_EQ (joined[i].getVector3fMap (), joined[i % single_->size ()].getVector3fMap ()) << "point " << i;
      error += std::abs (joined[i].getVector3fMap ().norm () - 1);
      before += std::abs ((*joined_)[i].getVector3fMap ().norm () - 1);
    }
    EXPECT_LT (error, 0.5 * before);
  }
}

TEST_F (CopiesTest, OnlyThoseThatAreIndexedMove)
{
  auto indices = pcl::make_shared<pcl::Indices> ();
  for (std::size_t i = single_->size (); i < 2 * single_->size (); ++i)
    indices->push_back (static_cast<pcl::index_t> (i));
  const Cloud joined = smoothed (joined_, [&] (NormalSmoothing<pcl::PointNormal>& smoothing) {
    smoothing.setIndices (indices);
    setNoise (smoothing);
  });
  const Cloud alone = smoothed (single_, setNoise);
  for (std::size_t i = 0; i < joined.size (); ++i) {
    const Cloud& expected = i / single_->size () == 1 ? alone : *single_;
    ASSERT_EQ (joined[i].getVector3fMap (), expected[i % single_->size ()].getVector3fMap ()) << "point " << i;
  }
}

TEST_F (CopiesTest, WithANormalServeThoseWithoutThatStay)
{
  const auto set = [] (NormalSmoothing<pcl::PointNormal>& smoothing) {
    smoothing.setNormalSource (NormalSource::INPUT);
    setNoise (smoothing);
  };
  const Cloud alone = smoothed (single_, set);
  for (std::size_t i = 0; i < single_->size (); ++i)
    (*joined_)[i].getNormalVector3fMap ().setZero ();
  const Cloud joined = smoothed (joined_, set);
  for (std::size_t i = 0; i < joined.size (); ++i) {
    const Cloud& expected = i < single_->size () ? *single_ : alone;
    ASSERT_EQ (joined[i].getVector3fMap (), expected[i % single_->size ()].getVector3fMap ()) << "point " << i;
  }
}

TEST_F (CopiesTest, BesidePointsThatAreNotFinite)
{
  const Cloud alone = smoothed (single_, setNoise);
  for (std::size_t i = 0; i < joined_->size (); i += 7)
    (*joined_)[i].y = nan_float;
  const Cloud joined = smoothed (joined_, setNoise);
  for (std::size_t i = 0; i < joined.size (); ++i)
    if (i % 7 != 0)
      ASSERT_EQ (joined[i].getVector3fMap (), alone[i % single_->size ()].getVector3fMap ()) << "point " << i;
    else
      ASSERT_TRUE (std::isnan (joined[i].y));
}

TEST_F (CopiesTest, AreRefusedInAGraphWhereEachPointCounts)
{
  const auto positions = readPositions (positionsOf (*joined_));
  BilateralNormalFilter<pcl::PointNormal> filter;
  filter.setInputCloud (joined_);
  filter.setNeighborGraph (NeighborGraph::build (positions, {16, 1, true}, core::Execution (2)));
  Cloud output;
  filter.filter (output);
  EXPECT_NE (filter.getErrorMessage ().find ("one place"), std::string::npos) << filter.getErrorMessage ();
}

TEST_F (CopiesTest, HideNoNoise)
{
  Cloud::Ptr rounded = pcl::make_shared<Cloud> (*single_); // joined with itself after rounding in another file format
  for (pcl::PointNormal point : *single_) {
    point.getVector3fMap () *= 1 + 1e-6f;
    rounded->push_back (point);
  }
  SurfaceNoiseEstimation<pcl::PointNormal> noise;
  for (const Cloud::Ptr& cloud : {single_, joined_, rounded}) {
    noise.setInputCloud (cloud);
    ASSERT_TRUE (noise.compute ()) << noise.getErrorMessage ();
    EXPECT_NEAR (noise.getSigma (), sigma, 0.15 * sigma);
  }
}
} // namespace
