// SPDX-License-Identifier: BSD-3-Clause
#include "feature_fixture.h"

#include <cmath>

namespace
{
using namespace test_support;

template <typename FeatureT>
class FeatureBadInput : public FeatureTest<FeatureT>
{};

TYPED_TEST_SUITE (FeatureBadInput, AllFeatures);

TYPED_TEST (FeatureBadInput, NoCloudIsAnError)
{
  TypeParam feature;
  feature.setKSearch (10);
  this->expectError (feature, "setInputCloud");
}

TYPED_TEST (FeatureBadInput, TooFewPointsAreAnError)
{
  TypeParam feature;
  this->replacePoints ({});
  this->prepare (feature);
  this->expectError (feature, "empty");
  for (const Vectors& points : {Vectors (this->shape_.points.begin (), this->shape_.points.begin () + 1),
                                Vectors (this->shape_.points.begin (), this->shape_.points.begin () + 2),
                                Vectors (10, Eigen::Vector3f::Constant (nan_float))}) {
    this->replacePoints (points);
    this->prepare (feature);
    this->expectError (feature, "finite points");
    feature.setIndices (std::make_shared<pcl::Indices> (pcl::Indices {0}));
    this->expectError (feature, "finite points");
    feature.setIndices (pcl::IndicesPtr ());
    feature.setSearchSurface (this->cloud_);
    this->expectError (feature, "finite points");
    feature.setSearchSurface (nullptr);
  }
}

TYPED_TEST (FeatureBadInput, FewerPointsThanKAreAllNeighbours)
{
  this->replacePoints (withNoise (planeGrid (2, 1).points, 0.1, 160));
  TypeParam feature;
  this->prepare (feature);
  feature.setKSearch (50);
  const auto output = this->run (feature);
  feature.setKSearch (4);
  this->expectSameNormals (output, this->run (feature));
  EXPECT_TRUE (output.is_dense);
}

TYPED_TEST (FeatureBadInput, PointsWithoutASurfaceHaveNoNormals)
{
  Vectors line;
  for (int i = 0; i < 40; ++i)
    line.push_back (static_cast<float> (i) * Eigen::Vector3f (1, 0, 0));
  for (const Vectors& points : {line, Vectors (40, Eigen::Vector3f (1, 2, 3))}) {
    this->replacePoints (points);
    const auto output = this->result ();
    ASSERT_EQ (output.size (), points.size ());
    EXPECT_FALSE (output.is_dense);
    for (const auto& point : output)
      EXPECT_TRUE (std::isnan (point.normal_x) && std::isnan (point.curvature)) << point;
  }
}

TYPED_TEST (FeatureBadInput, DuplicatesDoNotHarm)
{
  Vectors twice = this->shape_.points;
  twice.insert (twice.end (), this->shape_.points.begin (), this->shape_.points.end ());
  this->replacePoints (twice);
  const auto output = this->result ();
  EXPECT_TRUE (output.is_dense);
  for (const auto& point : output)
    EXPECT_TRUE (this->hasNormal (point)) << point;
}

TYPED_TEST (FeatureBadInput, ParametersOutOfRangeAreErrors)
{
  TypeParam feature;
  this->prepare (feature);
  feature.setKSearch (-3);
  this->expectError (feature, "-3");
  feature.setKSearch (10);
  feature.setRadiusSearch (0.75);
  this->expectError (feature, "0.75");
  feature.setKSearch (0);
  for (const auto& [radius, name] : {std::pair (-0.5, "-0.5"), std::pair (double (nan_float), "nan")}) {
    feature.setRadiusSearch (radius);
    this->expectError (feature, name);
  }
  feature.setRadiusSearch (0);
  this->expectError (feature, "neither k nor a radius");
  feature.setKSearch (10);
  feature.setMaxNeighborDistance (-0.5);
  this->expectError (feature, "-0.5");
  feature.setMaxNeighborDistance (0);
  this->expectSameNormals (this->run (feature), this->result ());
}

TYPED_TEST (FeatureBadInput, AnIndexOutOfRangeIsAnError)
{
  for (const int wrong : {300, 2147483647, -1}) {
    TypeParam feature;
    this->prepare (feature);
    feature.setIndices (std::make_shared<pcl::Indices> (pcl::Indices {1, wrong}));
    this->expectError (feature, std::to_string (wrong));
  }
}

using Hough = pcl_normal_smoothing::HoughNormalEstimation<pcl::PointXYZ, pcl::Normal>;

class HoughBadInput : public FeatureTest<Hough>
{};

TEST_F (HoughBadInput, ParametersOutOfRangeAreErrors)
{
  const auto refused = [this] (void (*set) (Hough&), const std::string& part) {
    Hough hough;
    prepare (hough);
    set (hough);
    expectError (hough, part);
  };
  refused ([] (Hough& hough) { hough.setConfidence (1.5); }, "confidence");
  refused ([] (Hough& hough) { hough.setConfidence (1.5); }, "1.5");
  refused ([] (Hough& hough) { hough.setTolerance (-0.25); }, "tolerance");
  refused ([] (Hough& hough) { hough.setTolerance (-0.25); }, "-0.25");
  refused ([] (Hough& hough) { hough.setNumberOfBands (1); }, "bands");
  refused ([] (Hough& hough) { hough.setNumberOfBands (-17); }, "-17");
  refused ([] (Hough& hough) { hough.setNumberOfRotations (0); }, "rotations");
  refused ([] (Hough& hough) { hough.setNumberOfRotations (5001); }, "5001");
}
} // namespace
