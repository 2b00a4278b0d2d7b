// SPDX-License-Identifier: BSD-3-Clause
#include "feature_fixture.h"

#include <cmath>

namespace
{
using namespace test_support;

template <typename FeatureT>
class FeatureLifeCycle : public FeatureTest<FeatureT>
{};

TYPED_TEST_SUITE (FeatureLifeCycle, AllFeatures);

TYPED_TEST (FeatureLifeCycle, WritesANormalAndACurvatureForEveryPoint)
{
  const auto output = this->result ();
  ASSERT_EQ (output.size (), this->cloud_->size ());
  EXPECT_EQ (output.header, this->cloud_->header);
  EXPECT_TRUE (output.is_dense);
  double sum = 0;
  for (std::size_t i = 0; i < output.size (); ++i) {
    const Eigen::Vector3f normal = output[i].getNormalVector3fMap ();
    EXPECT_NEAR (normal.norm (), 1, 1e-5);
    EXPECT_GE (output[i].curvature, 0);
    EXPECT_LE (output[i].curvature, 1.0f / 3);
    sum += lineAngleDegrees (normal.cast<double> (), this->shape_.normals[i].template cast<double> ());
  }
  EXPECT_LT (sum / static_cast<double> (output.size ()), 20);
}

TYPED_TEST (FeatureLifeCycle, WritesOneOutputForEveryIndexInTheirOrder)
{
  const auto full = this->result ();
  TypeParam feature;
  this->prepare (feature);
  const pcl::Indices chosen {299, 7, 7, 120, 0};
  feature.setIndices (std::make_shared<pcl::Indices> (chosen));
  const auto output = this->run (feature);
  ASSERT_EQ (output.size (), chosen.size ());
  EXPECT_EQ (output.width, chosen.size ());
  EXPECT_EQ (output.height, 1u);
  for (std::size_t i = 0; i < chosen.size (); ++i)
    EXPECT_TRUE (this->sameNormal (output[i], full[chosen[i]])) << "output " << i;
  feature.setIndices (std::make_shared<pcl::Indices> ());
  EXPECT_TRUE (this->run (feature).empty ());
}

TYPED_TEST (FeatureLifeCycle, ASearchSurfaceIsWhereTheNeighboursAre)
{
  const auto full = this->result ();
  // The input consists of some points of the surface, with other indices than in it.
  const pcl::Indices chosen {250, 3, 77, 160};
  auto input = std::make_shared<typename TestFixture::CloudIn> ();
  for (const auto index : chosen)
    input->push_back ((*this->cloud_)[index]);
  input->sensor_origin_ = this->cloud_->sensor_origin_;
  TypeParam feature;
  this->prepare (feature);
  feature.setInputCloud (input);
  feature.setSearchSurface (this->cloud_);
  const auto output = this->run (feature);
  ASSERT_EQ (output.size (), chosen.size ());
  for (std::size_t i = 0; i < chosen.size (); ++i)
    EXPECT_TRUE (this->sameNormal (output[i], full[chosen[i]])) << "output " << i;

  feature.setIndices (std::make_shared<pcl::Indices> (pcl::Indices {2}));
  const auto one = this->run (feature);
  ASSERT_EQ (one.size (), 1u);
  EXPECT_TRUE (this->sameNormal (one[0], full[77]));
}

TYPED_TEST (FeatureLifeCycle, APointThatIsNotFiniteHasNoNormalAndIsNobodysNeighbour)
{
  auto finite = std::make_shared<typename TestFixture::CloudIn> ();
  finite->sensor_origin_ = this->cloud_->sensor_origin_;
  for (std::size_t i = 0; i < this->cloud_->size (); ++i)
    if (i % 7 == 3)
      (*this->cloud_)[i].getVector3fMap ()[static_cast<int> (i % 3)] =
          i % 2 == 0 ? nan_float : std::numeric_limits<float>::infinity ();
    else
      finite->push_back ((*this->cloud_)[i]);
  TypeParam of_finite;
  this->prepare (of_finite);
  of_finite.setInputCloud (finite);
  const auto expected = this->run (of_finite);
  for (const bool is_dense : {true, false}) { // users' flags are often wrong
    this->cloud_->is_dense = is_dense;
    const auto output = this->result ();
    EXPECT_FALSE (output.is_dense);
    std::size_t j = 0;
    for (std::size_t i = 0; i < output.size (); ++i) {
      EXPECT_EQ (this->hasNormal (output[i]), i % 7 != 3) << "point " << i;
      EXPECT_TRUE (i % 7 == 3 || this->sameNormal (output[i], expected[j++])) << "point " << i;
    }
  }
}

TYPED_TEST (FeatureLifeCycle, FewerThanThreeNeighboursGiveNoNormal)
{
  (*this->cloud_)[5].x = 100; // isolated
  TypeParam feature;
  this->prepare (feature);
  feature.setKSearch (0);
  feature.setRadiusSearch (0.5);
  const auto output = this->run (feature);
  EXPECT_FALSE (output.is_dense);
  for (std::size_t i = 0; i < output.size (); ++i)
    EXPECT_EQ (this->hasNormal (output[i]), i != 5) << "point " << i;
}

TYPED_TEST (FeatureLifeCycle, OrganisedCloudsStayOrganised)
{
  const auto flat = this->result ();
  this->cloud_->width = 20;
  this->cloud_->height = 15;
  const auto output = this->result ();
  EXPECT_EQ (output.width, 20u);
  EXPECT_EQ (output.height, 15u);
  this->expectSameNormals (output, flat);
}

TYPED_TEST (FeatureLifeCycle, NormalsPointToTheViewpoint)
{
  const auto expectTowards = [&] (const auto& output, const Eigen::Vector3f& view_point) {
    for (std::size_t i = 0; i < output.size (); ++i) {
      const Eigen::Vector3f normal = output[i].getNormalVector3fMap ();
      EXPECT_GE (normal.dot (view_point - this->shape_.points[i]), 0) << "point " << i;
    }
  };
  const Eigen::Vector3f sensor (0.5f, -0.25f, 8), other (-3, 40, 1);
  TypeParam feature;
  this->prepare (feature);
  expectTowards (this->run (feature), sensor);
  feature.setViewPoint (other.x (), other.y (), other.z ());
  expectTowards (this->run (feature), other);
  Eigen::Vector3f told;
  feature.getViewPoint (told.x (), told.y (), told.z ());
  EXPECT_EQ (told, other);
  feature.useSensorOriginAsViewPoint ();
  expectTowards (this->run (feature), sensor);
  feature.getViewPoint (told.x (), told.y (), told.z ());
  EXPECT_EQ (told, sensor);
}

TYPED_TEST (FeatureLifeCycle, OneObjectServesOneCloudAfterAnother)
{
  const auto expected = this->result ();
  const Shape ball = sphere (500, 2);
  TypeParam feature;
  this->prepare (feature);
  feature.setInputCloud (makeCloud<typename TestFixture::PointIn> (ball.points, ball.normals));
  EXPECT_EQ (this->run (feature).size (), 500u);
  feature.setSearchSurface (this->cloud_);
  this->run (feature);
  feature.setSearchSurface (nullptr);
  feature.setInputCloud (this->cloud_);
  this->expectSameNormals (this->run (feature), expected);
  TypeParam copy = feature;
  this->expectSameNormals (this->run (copy), expected);
}
} // namespace
