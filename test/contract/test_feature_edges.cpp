// SPDX-License-Identifier: BSD-3-Clause
#include "feature_fixture.h"
#include "searches.h"

#include <cmath>
#include <utility>

namespace
{
using namespace test_support;

template <typename FeatureT>
class FeatureEdges : public FeatureTest<FeatureT>
{
protected:
  /** WPCA uses only the other points, and any two of them are collinear. */
  static constexpr int least_k =
      std::is_same_v<FeatureT, pcl_normal_smoothing::HoughNormalEstimation<pcl::PointXYZ, pcl::Normal>> ? 3 : 4;
};

TYPED_TEST_SUITE (FeatureEdges, OneOfEachFeature);

TYPED_TEST (FeatureEdges, AsManyPointsAsNeighboursOneLessAndOneMore)
{
  for (const int count : {int (TestFixture::least_k), 9, 10, 11}) {
    SCOPED_TRACE (count);
    this->replacePoints (Vectors (this->shape_.points.begin (), this->shape_.points.begin () + count));
    const auto output = this->result ();
    ASSERT_EQ (output.size (), static_cast<std::size_t> (count));
    for (const auto& point : output)
      EXPECT_TRUE (this->hasNormal (point)) << point;
    TypeParam of_all;
    this->prepare (of_all);
    of_all.setKSearch (std::min (count, 10));
    this->expectSameNormals (this->run (of_all), output);
  }
}

TYPED_TEST (FeatureEdges, APlaneHasItsNormal)
{
  this->replacePoints (planeGrid (12, 0.125f).points);
  for (const auto& point : this->result ()) {
    EXPECT_NEAR (std::abs (point.normal_z), 1, 1e-6) << point;
    EXPECT_NEAR (point.curvature, 0, 1e-6) << point;
  }
}

TYPED_TEST (FeatureEdges, EveryUnitGivesTheSame)
{
  const auto expected = this->result ();
  for (const double scale : {1e-30, 1e-22, 1e-9, 1e9, 1e22, 1e30, std::ldexp (1.0, -100), std::ldexp (1.0, 100)}) {
    SCOPED_TRACE (scale);
    Vectors points;
    for (const auto& point : this->shape_.points)
      points.push_back ((scale * point.template cast<double> ()).template cast<float> ());
    const auto origin = this->cloud_->sensor_origin_;
    this->replacePoints (points);
    double sum = 0;
    const auto compare = [&] (const auto& output) {
      ASSERT_EQ (output.size (), expected.size ());
      for (std::size_t i = 0; i < output.size (); ++i)
        sum += lineAngleDegrees (output[i].getNormalVector3fMap ().template cast<double> (),
                                 expected[i].getNormalVector3fMap ().template cast<double> ());
    };
    compare (this->result ());
    TypeParam by_queries;
    this->prepare (by_queries);
    by_queries.setSearchSurface (this->cloud_);
    compare (this->run (by_queries));
    EXPECT_LT (sum / 600, 2); // the Hough transform draws other triples
    this->cloud_->sensor_origin_ = origin;
  }
}

TYPED_TEST (FeatureEdges, ParametersAtTheirBoundsGiveNormalsOrNone)
{
  TypeParam feature;
  this->prepare (feature);
  for (const int k : {1, 2, 3, 4, 300, 301, 2147483647}) {
    feature.setKSearch (k);
    if (k < TestFixture::least_k) {
      this->expectError (feature, "k is " + std::to_string (k));
      continue;
    }
    const auto output = this->run (feature);
    ASSERT_EQ (output.size (), 300u);
    EXPECT_TRUE (output.is_dense);
  }
  feature.setSearchSurface (makeCloud<typename TestFixture::PointIn> (sphere (300, 2).points, this->shape_.normals));
  feature.setKSearch (3); // none of the neighbours is the point itself
  EXPECT_TRUE (this->run (feature).is_dense);
  feature.setSearchSurface (nullptr);
  feature.setKSearch (0);
  for (const double radius : {1e-37, 1e-30, 1e30, 1e38}) {
    feature.setRadiusSearch (radius);
    EXPECT_EQ (this->run (feature).is_dense, radius > 1) << radius;
  }
  for (const auto& [radius, name] : {std::pair (1e-300, "1e-300"), std::pair (1e300, "1e+300")}) {
    feature.setRadiusSearch (radius);
    this->expectError (feature, name);
  }
}

TYPED_TEST (FeatureEdges, CopiedAndMovedItGivesTheSame)
{
  const auto expected = this->result ();
  TypeParam feature;
  this->prepare (feature);
  TypeParam copy (feature), moved (std::move (feature)), assigned;
  this->expectSameNormals (this->run (copy), expected);
  this->expectSameNormals (this->run (moved), expected);
  assigned = std::move (moved);
  this->expectSameNormals (this->run (assigned), expected);
  this->expectSameNormals (this->run (copy), expected);
}

TYPED_TEST (FeatureEdges, TwoObjectsRunInTwoThreadsAtOnce)
{
  const auto expected = this->result ();
  for (const auto& output : resultsOfTwoThreads ([this] { return this->result (); }))
    this->expectSameNormals (output, expected);
}

TYPED_TEST (FeatureEdges, TheSearchForCamerasWorksOnTheirCloudsAlone)
{
  TypeParam feature;
  this->prepare (feature);
  feature.setSearchMethod (organizedSearch<typename TestFixture::PointIn> ());
  this->expectError (feature, "300 x 1");
  this->replacePoints (cameraView ());
  this->cloud_->width = 24;
  this->cloud_->height = 20;
  const auto expected = this->result ();
  feature.setInputCloud (this->cloud_);
  this->expectSameNormals (this->run (feature), expected);
}
} // namespace
