// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "clouds.h"

#include <pcl_normal_smoothing/hough_normal_estimation.h>
#include <pcl_normal_smoothing/wpca_normal_estimation.h>

namespace test_support
{
template <typename FeatureT>
struct FeatureTraits;

template <template <typename, typename> class FeatureTemplate, typename PointInT, typename PointOutT>
struct FeatureTraits<FeatureTemplate<PointInT, PointOutT>>
{
  using PointIn = PointInT;
  using PointOut = PointOutT;
};

/** One of the two estimators, on a noisy torus. */
template <typename FeatureT>
class FeatureTest : public testing::Test
{
protected:
  using PointIn = typename FeatureTraits<FeatureT>::PointIn;
  using PointOut = typename FeatureTraits<FeatureT>::PointOut;
  using CloudIn = pcl::PointCloud<PointIn>;
  using CloudOut = pcl::PointCloud<PointOut>;

  explicit FeatureTest (int count = 300)
  {
    shape_ = torus (count, 1, 0.4);
    shape_.points = withNoise (shape_.points, 0.01, 130);
    cloud_ = makeCloud<PointIn> (shape_.points, shape_.normals);
  }

  void
  replacePoints (const Vectors& points)
  {
    cloud_ = makeCloud<PointIn> (points, Vectors (points.size (), Eigen::Vector3f::UnitZ ()));
  }

  void
  prepare (FeatureT& feature) const
  {
    feature.setInputCloud (cloud_);
    feature.setNumberOfThreads (2);
    feature.setKSearch (10);
  }

  static CloudOut
  run (FeatureT& feature)
  {
    CloudOut output = poisonedCloud<PointOut> ();
    feature.compute (output);
    EXPECT_EQ (feature.getErrorMessage (), "");
    EXPECT_FALSE (feature.wasCancelled ());
    return output;
  }

  static void
  expectError (FeatureT& feature, const std::string& part)
  {
    CloudOut output = poisonedCloud<PointOut> ();
    feature.compute (output);
    expectEmpty (output);
    EXPECT_TRUE (contains (feature.getErrorMessage (), part))
        << "'" << feature.getErrorMessage () << "' without " << part;
    EXPECT_FALSE (feature.wasCancelled ());
  }

  CloudOut
  result () const
  {
    FeatureT feature;
    prepare (feature);
    return run (feature);
  }

  static bool
  hasNormal (const PointOut& point)
  {
    return std::isfinite (point.normal_x) && std::isfinite (point.curvature);
  }

  static bool
  sameNormal (const PointOut& a, const PointOut& b)
  {
    const auto same = [] (float x, float y) { return std::memcmp (&x, &y, sizeof x) == 0; };
    return same (a.normal_x, b.normal_x) && same (a.normal_y, b.normal_y) && same (a.normal_z, b.normal_z) &&
           same (a.curvature, b.curvature);
  }

  /** Compares what a feature writes, normal and curvature; it leaves other fields of its output type alone. */
  static void
  expectSameNormals (const CloudOut& actual, const CloudOut& expected)
  {
    ASSERT_EQ (actual.size (), expected.size ());
    for (std::size_t i = 0; i < expected.size (); ++i)
      ASSERT_TRUE (sameNormal (actual[i], expected[i]))
          << "output " << i << " is " << actual[i] << ", not " << expected[i];
  }

  Shape shape_;
  typename CloudIn::Ptr cloud_;
};

using AllFeatures =
    testing::Types<pcl_normal_smoothing::WPCANormalEstimation<pcl::PointXYZ, pcl::Normal>,
                   pcl_normal_smoothing::WPCANormalEstimation<pcl::PointXYZI, pcl::Normal>,
                   pcl_normal_smoothing::WPCANormalEstimation<pcl::PointXYZRGB, pcl::PointXYZRGBNormal>,
                   pcl_normal_smoothing::WPCANormalEstimation<pcl::PointXYZRGBA, pcl::Normal>,
                   pcl_normal_smoothing::WPCANormalEstimation<pcl::PointNormal, pcl::PointNormal>,
                   pcl_normal_smoothing::WPCANormalEstimation<pcl::PointXYZINormal, pcl::PointXYZINormal>,
                   pcl_normal_smoothing::WPCANormalEstimation<pcl::PointXYZRGBNormal, pcl::Normal>,
                   pcl_normal_smoothing::HoughNormalEstimation<pcl::PointXYZ, pcl::Normal>,
                   pcl_normal_smoothing::HoughNormalEstimation<pcl::PointXYZRGB, pcl::Normal>,
                   pcl_normal_smoothing::HoughNormalEstimation<pcl::PointNormal, pcl::PointNormal>>;

using OneOfEachFeature = testing::Types<pcl_normal_smoothing::WPCANormalEstimation<pcl::PointXYZ, pcl::Normal>,
                                        pcl_normal_smoothing::HoughNormalEstimation<pcl::PointXYZ, pcl::Normal>>;
} // namespace test_support
