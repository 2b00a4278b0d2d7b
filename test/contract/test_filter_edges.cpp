// SPDX-License-Identifier: BSD-3-Clause
#include "filter_fixture.h"
#include "searches.h"

#include <cmath>
#include <utility>

namespace
{
using namespace test_support;

/** Cases at and just beyond the limits of what is possible. */
template <typename FilterT>
class FilterEdges : public FilterTest<FilterT>
{
protected:
  using Cloud = typename FilterEdges::Cloud;

  static void
  prepareFor (FilterT& filter, const Vectors& points, const Vectors& normals)
  {
    FilterEdges::prepare (filter, makeCloud<typename FilterEdges::Point> (points, normals), normals);
    filter.setKSearch (10);
  }

  /** Expects one finite point per input point, or an empty output and a message. */
  static void
  expectDefined (FilterT& filter, std::size_t size)
  {
    Cloud output = poisonedCloud<typename FilterEdges::Point> ();
    filter.filter (output);
    if (!filter.getErrorMessage ().empty ())
      return expectEmpty (output);
    ASSERT_EQ (output.size (), size);
    for (const auto& point : output) {
      EXPECT_TRUE (point.getVector3fMap ().allFinite ()) << point;
      if constexpr (FilterEdges::has_normal) {
        EXPECT_TRUE (point.getNormalVector3fMap ().allFinite ()) << point;
      }
    }
  }
};

TYPED_TEST_SUITE (FilterEdges, OneOfEachFilter);

TYPED_TEST (FilterEdges, AsManyPointsAsNeighboursOneLessAndOneMore)
{
  for (const std::size_t count : {3u, 9u, 10u, 11u}) {
    SCOPED_TRACE (count);
    const auto end = static_cast<std::ptrdiff_t> (count);
    const Vectors points (this->points_.begin (), this->points_.begin () + end);
    const Vectors normals (this->normals_.begin (), this->normals_.begin () + end);
    TypeParam filter, of_all;
    this->prepareFor (filter, points, normals);
    const auto output = this->run (filter);
    EXPECT_EQ (output.size (), count);
    this->expectDefined (filter, count);
    if (count > 10 || (count < 7 && TestFixture::Traits::estimates_normals)) // too few for k, but a valid cloud
      continue;
    this->prepareFor (of_all, points, normals);
    of_all.setKSearch (static_cast<int> (count));
    expectSamePoints (output, this->run (of_all));
  }
}

TYPED_TEST (FilterEdges, APlaneStays)
{
  const Shape plane = planeGrid (17, 0.125f); // parallel to the axes, and rotated
  const Eigen::Matrix3f turn = Eigen::Quaternionf (0.4f, 0.2f, -0.3f, 0.8f).normalized ().toRotationMatrix ();
  for (const Eigen::Matrix3f& rotation : {Eigen::Matrix3f (Eigen::Matrix3f::Identity ()), turn}) {
    Vectors points, normals;
    for (std::size_t i = 0; i < plane.size (); ++i) {
      points.push_back (rotation * plane.points[i]);
      normals.push_back (rotation * plane.normals[i]);
    }
    TypeParam filter;
    this->prepareFor (filter, points, normals);
    const auto output = this->run (filter);
    for (std::size_t i = 0; i < output.size (); ++i)
      EXPECT_LT ((output[i].getVector3fMap () - points[i]).norm (), 1e-5) << "point " << i;
  }
}

TYPED_TEST (FilterEdges, ParametersAtTheirBoundsGiveFiniteNumbersOrAMessage)
{
  const auto expectFine = [this] (const auto& set) {
    TypeParam filter;
    this->prepare (filter);
    set (filter);
    this->expectDefined (filter, this->points_.size ());
  };
  for (const int k : {1, 2, 3, 300, 301})
    expectFine ([=] (TypeParam& filter) { filter.setKSearch (k); });
  for (const double length : {1e-300, 1e-40, 1e-30, 1e-6, 1e30, 1e38, 1e300}) {
    expectFine ([=] (TypeParam& filter) {
      filter.setKSearch (0);
      filter.setRadiusSearch (length);
    });
    expectFine ([=] (TypeParam& filter) { filter.setMaxNeighborDistance (length); });
    expectFine ([=] (TypeParam& filter) { filter.setSigmaS (length); });
    if constexpr (TestFixture::Traits::writes_points)
      expectFine ([=] (TypeParam& filter) { filter.setMaxDisplacement (length); });
  }
  expectFine ([] (TypeParam& filter) { filter.setNumberOfThreads (4000000000u); });
}

TYPED_TEST (FilterEdges, NoIterationsChangeNothing)
{
  TypeParam filter;
  this->prepare (filter);
  if constexpr (TestFixture::Traits::estimates_normals)
    filter.setPointIterations (0);
  else
    filter.setMaxIterations (0);
  const auto output = this->run (filter);
  for (std::size_t i = 0; i < output.size (); ++i)
    EXPECT_EQ (output[i].getVector3fMap (), this->points_[i]) << "point " << i;
}

TYPED_TEST (FilterEdges, CopiedAndMovedItGivesTheSame)
{
  const auto expected = this->result ();
  TypeParam filter;
  this->prepare (filter);
  TypeParam copy (filter), assigned;
  assigned = filter;
  expectSamePoints (this->run (copy), expected);
  expectSamePoints (this->run (assigned), expected);
  TypeParam moved (std::move (filter)), moved_to;
  expectSamePoints (this->run (moved), expected);
  moved_to = std::move (moved);
  expectSamePoints (this->run (moved_to), expected);
  expectSamePoints (this->run (copy), expected); // they share nothing that can change
}

TYPED_TEST (FilterEdges, TheSearchForCamerasGivesTheSameOnTheirClouds)
{
  const Vectors points = cameraView (), normals (points.size (), -Eigen::Vector3f::UnitZ ());
  const auto cloud = makeCloud<typename TestFixture::Point> (points, normals);
  cloud->width = 24;
  cloud->height = 20;
  TypeParam filter;
  this->prepare (filter, cloud, normals);
  filter.setKSearch (10);
  const auto expected = this->run (filter);
  filter.setSearchMethod (organizedSearch<typename TestFixture::Point> ());
  expectSamePoints (this->run (filter), expected);
}

TYPED_TEST (FilterEdges, TheSearchForCamerasIsRefusedOnOtherClouds)
{
  TypeParam filter;
  this->prepare (filter);
  filter.setSearchMethod (organizedSearch<typename TestFixture::Point> ());
  this->expectError (filter, "300 x 1");
  this->cloud_->width = 20;
  this->cloud_->height = 15;
  this->expectError (filter, "20 x 15");
}
} // namespace
