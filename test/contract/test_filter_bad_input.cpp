// SPDX-License-Identifier: BSD-3-Clause
#include "filter_fixture.h"

#include <cmath>

namespace
{
using namespace test_support;
using namespace pcl_normal_smoothing;

template <typename FilterT>
class FilterBadInput : public FilterTest<FilterT>
{
protected:
  /** Prepares the filter for other points than the fixture's. */
  void
  prepareFor (FilterT& filter, const Vectors& points, const Vectors& normals)
  {
    this->cloud_ = makeCloud<typename FilterBadInput::Point> (points, normals);
    this->prepare (filter, this->cloud_, normals);
    filter.setKSearch (10);
  }

  static void
  expectFinite (const typename FilterBadInput::Cloud& cloud)
  {
    for (const auto& point : cloud) {
      EXPECT_TRUE (point.getVector3fMap ().allFinite ()) << point;
      if constexpr (FilterBadInput::has_normal) {
        EXPECT_TRUE (point.getNormalVector3fMap ().allFinite ()) << point;
      }
    }
  }
};

TYPED_TEST_SUITE (FilterBadInput, AllFilters);

TYPED_TEST (FilterBadInput, TooFewPointsAreAnError)
{
  const Vectors up (10, Eigen::Vector3f::UnitZ ());
  for (std::size_t count = 0; count < 3; ++count) {
    TypeParam filter;
    this->prepareFor (filter, Vectors (this->points_.begin (), this->points_.begin () + std::ptrdiff_t (count)), up);
    if constexpr (!TestFixture::has_normal)
      filter.setInputNormals (makeNormals (Vectors (count, up[0])));
    this->expectError (filter, std::to_string (count) + " finite points");
  }
  TypeParam filter;
  this->prepareFor (filter, Vectors (10, Eigen::Vector3f::Constant (nan_float)), up);
  this->expectError (filter, "0 finite points");
}

TYPED_TEST (FilterBadInput, FewerPointsThanKAreAllNeighbours)
{
  const Shape plane = planeGrid (3, 1);
  TypeParam filter, with_all;
  this->prepareFor (filter, withNoise (plane.points, 0.1, 150), plane.normals);
  filter.setKSearch (50);
  const auto output = this->run (filter);
  this->prepare (with_all, this->cloud_, plane.normals);
  with_all.setKSearch (9);
  expectSamePoints (output, this->run (with_all));
}

TYPED_TEST (FilterBadInput, PointsWithoutASurfaceStayOrAreAnError)
{
  Vectors line;
  for (int i = 0; i < 40; ++i)
    line.push_back (static_cast<float> (i) * Eigen::Vector3f (1, 0, 0));
  const Vectors equal (40, Eigen::Vector3f (1, 2, 3)), up (40, Eigen::Vector3f::UnitZ ());
  for (const Vectors& points : {line, equal}) {
    TypeParam filter;
    this->prepareFor (filter, points, up);
    if (FilterTraits<TypeParam>::estimates_normals)
      this->expectError (filter, "no point has a normal");
    else
      expectSamePoints (this->run (filter), *this->cloud_); // with equal normals, nothing moves
  }
}

TYPED_TEST (FilterBadInput, DuplicatesDoNotHarm)
{
  Vectors twice = this->points_, normals = this->normals_;
  twice.insert (twice.end (), this->points_.begin (), this->points_.end ());
  normals.insert (normals.end (), this->normals_.begin (), this->normals_.end ());
  TypeParam filter;
  this->prepareFor (filter, twice, normals);
  const auto output = this->run (filter);
  ASSERT_EQ (output.size (), 600u);
  this->expectFinite (output);
  for (std::size_t i = 0; i < 300; ++i) // however ties are ordered, copies stay together
    EXPECT_LT ((output[i].getVector3fMap () - output[i + 300].getVector3fMap ()).norm (), 0.02) << "point " << i;
}

TYPED_TEST (FilterBadInput, ParametersOutOfRangeAreErrors)
{
  TypeParam filter;
  this->prepare (filter);
  filter.setKSearch (-3);
  this->expectError (filter, "-3");
  filter.setKSearch (10);
  filter.setRadiusSearch (0.75);
  this->expectError (filter, "0.75"); // both are set
  filter.setKSearch (0);
  for (const auto& [radius, name] : {std::pair (-0.5, "-0.5"), std::pair (double (nan_float), "nan"),
                                     std::pair (std::numeric_limits<double>::infinity (), "inf")}) {
    filter.setRadiusSearch (radius);
    this->expectError (filter, name);
  }
  filter.setRadiusSearch (0);
  filter.setKSearch (10);
  for (const auto& [distance, name] : {std::pair (-0.5, "-0.5"), std::pair (double (nan_float), "nan")}) {
    filter.setMaxNeighborDistance (distance);
    this->expectError (filter, name);
  }
  filter.setMaxNeighborDistance (0);
  for (const double sigma : {-0.25, 0.0, double (nan_float)}) {
    filter.setSigmaS (sigma);
    this->expectError (filter, core::numberText (sigma));
  }
  filter.setSigmaS (0.3);
  expectSamePoints (this->run (filter), [&] {
    TypeParam fresh;
    this->prepare (fresh);
    fresh.setSigmaS (0.3);
    return this->run (fresh);
  }()); // no error leaves a trace
}

TYPED_TEST (FilterBadInput, NeitherKNorARadiusIsAnErrorWhereTheClassDoesNotChoose)
{
  TypeParam filter;
  this->prepare (filter);
  filter.setKSearch (0);
  if (FilterTraits<TypeParam>::estimates_normals)
    EXPECT_EQ (this->run (filter).size (), 300u);
  else
    this->expectError (filter, "neither k nor a radius");
}

TYPED_TEST (FilterBadInput, AnIndexOutOfRangeIsAnError)
{
  for (const int wrong : {300, 2147483647, -1}) {
    TypeParam filter;
    this->prepare (filter);
    filter.setIndices (std::make_shared<pcl::Indices> (pcl::Indices {1, wrong}));
    this->expectError (filter, std::to_string (wrong));
  }
}

TYPED_TEST (FilterBadInput, AnErrorInPlaceLeavesTheCloudAsItIs)
{
  const auto before = *this->cloud_;
  TypeParam filter;
  this->prepare (filter);
  filter.setKSearch (-3);
  filter.filter (*this->cloud_);
  EXPECT_TRUE (contains (filter.getErrorMessage (), "-3")) << filter.getErrorMessage ();
  expectSamePoints (*this->cloud_, before);
  expectSameFrame (*this->cloud_, before);

  pcl::Filter<typename TestFixture::Point>& as_pcl_knows_it = filter;
  as_pcl_knows_it.filter (*this->cloud_);
  expectEmpty (*this->cloud_);
  EXPECT_EQ (this->cloud_->header.frame_id, "scanner");
}

TYPED_TEST (FilterBadInput, NoCloudIsAnErrorAndLeavesNothingInTheOutput)
{
  TypeParam filter;
  filter.setKSearch (10);
  this->expectError (filter, "setInputCloud");
}

/** For the filters that read normals. */
template <typename FilterT>
class FilterBadNormals : public FilterTest<FilterT>
{};

using NormalReaders = testing::Types<BilateralNormalFilter<pcl::PointNormal>,
                                     NormalGuidedPointUpdate<pcl::PointNormal>,
                                     NormalGuidedPointUpdate<pcl::PointXYZ>,
                                     NormalSmoothing<pcl::PointNormal>,
                                     NormalSmoothing<pcl::PointXYZ>>;
TYPED_TEST_SUITE (FilterBadNormals, NormalReaders);

template <typename FilterT>
void
readNormals (FilterT& filter)
{
  if constexpr (FilterTraits<FilterT>::estimates_normals)
    filter.setNormalSource (NormalSource::INPUT);
}

TYPED_TEST (FilterBadNormals, OneMustBeThereForEveryPoint)
{
  TypeParam filter;
  this->prepare (filter);
  readNormals (filter);
  filter.setInputNormals (makeNormals (Vectors (299, Eigen::Vector3f::UnitX ())));
  this->expectError (filter, "299");
  filter.setInputNormals (nullptr);
  if (TestFixture::has_normal)
    EXPECT_EQ (this->run (filter).size (), 300u);
  else
    this->expectError (filter, "setInputNormals");
}

TYPED_TEST (FilterBadNormals, TheirLengthDoesNotMatterAndWhereThereIsNoneThePointStays)
{
  const Shape shape = torus (300, 1, 0.4);
  Vectors unit = shape.normals, scaled = shape.normals;
  for (std::size_t i = 0; i < unit.size (); ++i)
    scaled[i] *= i % 3 == 0 ? 8.0f : 0.125f; // powers of two, so that normalising is exact
  TypeParam filter;
  this->prepare (filter);
  readNormals (filter);
  filter.setInputNormals (makeNormals (unit));
  const auto expected = this->run (filter);
  filter.setInputNormals (makeNormals (scaled));
  const auto of_scaled = this->run (filter);
  for (std::size_t i = 0; i < expected.size (); ++i)
    EXPECT_LT ((of_scaled[i].getVector3fMap () - expected[i].getVector3fMap ()).norm (), 1e-5) << "point " << i;

  scaled[17].setZero ();
  scaled[18].setConstant (nan_float);
  scaled[19].setConstant (std::numeric_limits<float>::infinity ());
  filter.setInputNormals (makeNormals (scaled));
  const auto output = this->run (filter);
  for (std::size_t i = 0; i < output.size (); ++i) {
    EXPECT_TRUE (output[i].getVector3fMap ().allFinite ()) << "point " << i;
    EXPECT_TRUE (i < 17 || i > 19 || samePoint (output[i], (*this->cloud_)[i])) << "point " << i;
  }
}

class FilterNormals : public FilterTest<BilateralNormalFilter<pcl::PointXYZ>>
{
protected:
  /** Expects an error message that contains \a part, an empty output, and unchanged normals if the input's are the
    * output. */
  static void
  expectErrorOfNormals (BilateralNormalFilter<pcl::PointXYZ>& filter,
                        const NormalCloud::Ptr& normals,
                        const std::string& part)
  {
    const NormalCloud before = *normals;
    NormalCloud output = poisonedCloud<pcl::Normal> ();
    for (NormalCloud* of_filter : {&output, normals.get ()}) {
      filter.filterNormals (*of_filter);
      EXPECT_TRUE (contains (filter.getErrorMessage (), part))
          << "'" << filter.getErrorMessage () << "' without " << part;
    }
    expectEmpty (output);
    expectSamePoints (*normals, before);
  }
};

TEST_F (FilterNormals, InPlaceTheyAreThoseOfAnotherOutput)
{
  BilateralNormalFilter<pcl::PointXYZ> filter;
  prepare (filter);
  const NormalCloud::Ptr normals = makeNormals (normals_);
  filter.setInputNormals (normals);
  NormalCloud expected = poisonedCloud<pcl::Normal> ();
  filter.filterNormals (expected);
  ASSERT_EQ (expected.size (), 300u);
  filter.filterNormals (*normals);
  EXPECT_EQ (filter.getErrorMessage (), "");
  expectSamePoints (*normals, expected);
}

TEST_F (FilterNormals, AnErrorIsSaidAndLeavesThoseInPlaceAsTheyAre)
{
  BilateralNormalFilter<pcl::PointXYZ> filter;
  const NormalCloud::Ptr normals = makeNormals (normals_);
  filter.setInputNormals (normals);
  filter.setKSearch (10);
  expectErrorOfNormals (filter, normals, "setInputCloud");
  filter.setInputCloud (cloud_);
  filter.setKSearch (-3);
  expectErrorOfNormals (filter, normals, "-3");
  filter.setInputCloud (nullptr);
  expectErrorOfNormals (filter, normals, "setInputCloud"); // not the message of the run before
}
} // namespace
