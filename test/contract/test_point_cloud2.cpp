// SPDX-License-Identifier: BSD-3-Clause
#include "binary_cloud.h"
#include "clouds.h"

#include <pcl_normal_smoothing/normal_smoothing.h>

#include <pcl/search/kdtree.h>

#include <cmath>

namespace
{
using namespace test_support;
using namespace pcl_normal_smoothing;
using Smoothing = NormalSmoothing<pcl::PCLPointCloud2>;

class PointCloud2Test : public testing::Test
{
protected:
  PointCloud2Test ()
  {
    const Shape shape = torus (300, 1, 0.4);
    points_ = withNoise (shape.points, 0.03, 170);
    normals_ = withRandomSigns (shape.normals, 171);
  }

  static void
  prepare (Smoothing& smoothing, const pcl::PCLPointCloud2& cloud)
  {
    smoothing.setInputCloud (std::make_shared<pcl::PCLPointCloud2> (cloud));
    smoothing.setKSearch (10);
    smoothing.setNumberOfThreads (2);
  }

  static pcl::PCLPointCloud2
  run (Smoothing& smoothing)
  {
    pcl::PCLPointCloud2 output = poisonedBinaryCloud ();
    smoothing.filter (output);
    EXPECT_EQ (smoothing.getErrorMessage (), "");
    return output;
  }

  static void
  expectError (
      const pcl::PCLPointCloud2& cloud,
      const std::string& part,
      void (*set) (Smoothing&) = [] (Smoothing&) {})
  {
    Smoothing smoothing;
    prepare (smoothing, cloud);
    set (smoothing);
    pcl::PCLPointCloud2 output = poisonedBinaryCloud ();
    smoothing.filter (output);
    EXPECT_TRUE (contains (smoothing.getErrorMessage (), part))
        << "'" << smoothing.getErrorMessage () << "' without " << part;
    EXPECT_TRUE (output.data.empty ());
    EXPECT_EQ (output.width * output.height, 0u);
  }

  /** The result of the class template for the same points. */
  pcl::PointCloud<pcl::PointNormal>
  expected () const
  {
    NormalSmoothing<pcl::PointNormal> smoothing;
    smoothing.setInputCloud (makeCloud<pcl::PointNormal> (points_, normals_));
    smoothing.setKSearch (10);
    pcl::PointCloud<pcl::PointNormal> output;
    smoothing.filter (output);
    return output;
  }

  /** Compares every byte except those of the positions. */
  static void
  expectSameOtherFields (pcl::PCLPointCloud2 actual, const BinaryLayout& layout, const pcl::PCLPointCloud2& input)
  {
    ASSERT_EQ (actual.data.size (), input.data.size ());
    for (std::size_t i = 0; i < std::size_t (input.width) * input.height; ++i)
      std::memcpy (&actual.data[layout.begin (i)], &input.data[layout.begin (i)], 3 * layout.scalarSize ());
    EXPECT_EQ (actual.data, input.data);
  }

  Vectors points_;
  Vectors normals_;
};

TEST_F (PointCloud2Test, EqualsTheTemplateBitForBitAndKeepsEveryOtherByte)
{
  for (const BinaryLayout& layout : {BinaryLayout {}, BinaryLayout {20, 0}, BinaryLayout {20, 24}}) {
    const pcl::PCLPointCloud2 cloud = makeBinaryCloud (layout, points_);
    Smoothing smoothing;
    prepare (smoothing, cloud);
    const pcl::PCLPointCloud2 output = run (smoothing);
    EXPECT_EQ (output.width, cloud.width);
    EXPECT_EQ (output.height, cloud.height);
    EXPECT_EQ (output.row_step, cloud.row_step);
    EXPECT_EQ (output.point_step, cloud.point_step);
    EXPECT_EQ (output.is_dense, cloud.is_dense);
    EXPECT_EQ (output.header, cloud.header);
    ASSERT_EQ (output.fields.size (), cloud.fields.size ());
    expectSameOtherFields (output, layout, cloud);
    const auto of_template = expected ();
    for (std::size_t i = 0; i < points_.size (); ++i)
      EXPECT_EQ (layout.position (output, i).cast<float> (), of_template[i].getVector3fMap ()) << "point " << i;
  }
}

TEST_F (PointCloud2Test, WorksInPlaceAndWithIndices)
{
  const BinaryLayout layout;
  const pcl::PCLPointCloud2 cloud = makeBinaryCloud (layout, points_);
  Smoothing smoothing;
  prepare (smoothing, cloud);
  const pcl::PCLPointCloud2 full = run (smoothing);
  smoothing.setIndices (std::make_shared<pcl::Indices> (pcl::Indices {299, 4}));
  const pcl::PCLPointCloud2 some = run (smoothing);
  for (std::size_t i = 0; i < points_.size (); ++i)
    EXPECT_EQ (layout.position (some, i), layout.position (i == 299 || i == 4 ? full : cloud, i)) << "point " << i;

  auto in_place = std::make_shared<pcl::PCLPointCloud2> (cloud);
  Smoothing other;
  prepare (other, cloud);
  other.setInputCloud (in_place);
  other.filter (*in_place);
  EXPECT_EQ (in_place->data, full.data);
}

TEST_F (PointCloud2Test, SearchObjectsAndThreadsDoNotMatter)
{
  const pcl::PCLPointCloud2 cloud = makeBinaryCloud ({}, points_);
  Smoothing smoothing;
  prepare (smoothing, cloud);
  const pcl::PCLPointCloud2 expected = run (smoothing);
  for (const unsigned threads : {1u, 4u}) {
    smoothing.setNumberOfThreads (threads);
    EXPECT_EQ (run (smoothing).data, expected.data);
  }
  smoothing.setSearchMethod (std::make_shared<pcl::search::KdTree<pcl::PointXYZ>> ());
  EXPECT_EQ (run (smoothing).data, expected.data);
  smoothing.setSearchInterval (1);
  EXPECT_NE (run (smoothing).data, expected.data);
}

TEST_F (PointCloud2Test, DoublesFarFromTheOriginMoveAsAtTheOrigin)
{
  BinaryLayout layout;
  layout.as_double = true;
  const Eigen::Vector3d far (4.5e5, 5e6, 120);
  Smoothing near_smoothing, far_smoothing;
  prepare (near_smoothing, makeBinaryCloud (layout, points_));
  prepare (far_smoothing, makeBinaryCloud (layout, points_, far));
  const pcl::PCLPointCloud2 near_output = run (near_smoothing), far_output = run (far_smoothing);
  expectSameOtherFields (far_output, layout, makeBinaryCloud (layout, points_, far));
  // A few rounding errors of a float coordinate: the share of a step that the rounds take depends steeply on the
  // positions.
  for (std::size_t i = 0; i < points_.size (); ++i)
    EXPECT_LT ((layout.position (far_output, i) - far - layout.position (near_output, i)).norm (), 2e-6)
        << "point " << i;
  EXPECT_GT ((layout.position (far_output, 0) - far - points_[0].cast<double> ()).norm (), 1e-4);
}

TEST_F (PointCloud2Test, DoublesBeyondTheRangeOfFloatAreSmoothed)
{
  BinaryLayout layout;
  layout.as_double = true;
  Smoothing smoothing;
  const pcl::PCLPointCloud2 cloud = makeBinaryCloud (layout, points_);
  prepare (smoothing, cloud);
  const pcl::PCLPointCloud2 expected = run (smoothing);
  for (const int exponent : {-600, -150, 150, 600}) {
    pcl::PCLPointCloud2 scaled = cloud;
    const double scale = std::ldexp (1.0, exponent);
    for (std::size_t i = 0; i < points_.size (); ++i) {
      const Eigen::Vector3d position = scale * layout.position (cloud, i);
      std::memcpy (&scaled.data[layout.begin (i)], position.data (), sizeof position);
    }
    prepare (smoothing, scaled);
    const pcl::PCLPointCloud2 output = run (smoothing);
    for (std::size_t i = 0; i < points_.size (); ++i)
      EXPECT_EQ (layout.position (output, i), scale * layout.position (expected, i)) << "point " << i;
  }
}

TEST_F (PointCloud2Test, AnErrorInPlaceLeavesTheCloudAsItIs)
{
  const auto cloud = std::make_shared<pcl::PCLPointCloud2> (makeBinaryCloud ({}, points_));
  const pcl::PCLPointCloud2 before = *cloud;
  Smoothing smoothing;
  smoothing.setInputCloud (cloud);
  smoothing.setKSearch (-3);
  smoothing.filter (*cloud);
  EXPECT_NE (smoothing.getErrorMessage (), "");
  EXPECT_EQ (cloud->data, before.data);
  EXPECT_EQ (cloud->width, before.width);

  Smoothing without_input;
  pcl::PCLPointCloud2 output = poisonedBinaryCloud ();
  without_input.filter (output);
  EXPECT_TRUE (contains (without_input.getErrorMessage (), "setInputCloud"));
  EXPECT_TRUE (output.data.empty ());
}

TEST_F (PointCloud2Test, NormalsAreReadAndWrittenWhereAsked)
{
  pcl::PCLPointCloud2 cloud;
  pcl::toPCLPointCloud2 (*makeCloud<pcl::PointNormal> (points_, normals_), cloud);
  Smoothing smoothing;
  prepare (smoothing, cloud);
  pcl::PointCloud<pcl::PointNormal> kept;
  pcl::fromPCLPointCloud2 (run (smoothing), kept);
  smoothing.setSaveNormals (true);
  pcl::PCLPointCloud2 written;
  pcl::toPCLPointCloud2 (expected (), written);
  EXPECT_EQ (run (smoothing).data, written.data);
  for (std::size_t i = 0; i < kept.size (); ++i)
    EXPECT_EQ (kept[i].getNormalVector3fMap (), normals_[i]) << "point " << i;

  smoothing.setNormalSource (NormalSource::INPUT);
  EXPECT_NE (run (smoothing).data, cloud.data);
  const auto from_input = [] (Smoothing& of_input) { of_input.setNormalSource (NormalSource::INPUT); };
  expectError (makeBinaryCloud ({}, points_), "normal_x", from_input);
  expectError (makeBinaryCloud ({}, points_), "normal_x", [] (Smoothing& saving) {
    saving.setSaveNormals (true);
    saving.setProgressCallback ([] (double) {
      ADD_FAILURE () << "smooths for nothing";
      return true;
    });
  });
}

TEST_F (PointCloud2Test, PointsThatAreNotFiniteStayAsTheyAre)
{
  const BinaryLayout layout;
  points_[7].x () = nan_float;
  points_[8].y () = std::numeric_limits<float>::infinity ();
  const pcl::PCLPointCloud2 cloud = makeBinaryCloud (layout, points_);
  Smoothing smoothing;
  prepare (smoothing, cloud);
  const pcl::PCLPointCloud2 output = run (smoothing);
  for (const std::size_t i : {7, 8})
    EXPECT_EQ (std::memcmp (&output.data[layout.begin (i)], &cloud.data[layout.begin (i)], 12), 0);
  EXPECT_NE (layout.position (output, 9), layout.position (cloud, 9));
}

TEST_F (PointCloud2Test, CancelledItsOutputIsTheInput)
{
  const pcl::PCLPointCloud2 cloud = makeBinaryCloud ({}, points_);
  Smoothing smoothing;
  prepare (smoothing, cloud);
  run (smoothing);
  EXPECT_GT (smoothing.usedOptions ().rounds.noise.sigma, 0);
  smoothing.setProgressCallback ([] (double share) { return share < 0.8; });
  pcl::PCLPointCloud2 output = poisonedBinaryCloud ();
  smoothing.filter (output);
  EXPECT_TRUE (smoothing.wasCancelled ());
  EXPECT_EQ (smoothing.usedOptions ().rounds.noise.sigma, 0);
  EXPECT_EQ (output.data, cloud.data);
  EXPECT_EQ (output.width, cloud.width);
}

TEST_F (PointCloud2Test, WhatIsNoCloudIsAnError)
{
  const pcl::PCLPointCloud2 good = makeBinaryCloud ({}, points_);
  expectError (pcl::PCLPointCloud2 (), "no field x");
  pcl::PCLPointCloud2 bad = good;
  bad.fields.erase (bad.fields.begin () + 1);
  expectError (bad, "no field y");
  bad = good;
  bad.fields[1].datatype = pcl::PCLPointField::INT32;
  expectError (bad, "x, y, z");
  expectError (makeBinaryCloud ({}, {}), "0 finite points");
  expectError (good, "-3", [] (Smoothing& smoothing) { smoothing.setKSearch (-3); });
  expectError (good, "300", [] (Smoothing& smoothing) {
    smoothing.setIndices (std::make_shared<pcl::Indices> (pcl::Indices {300}));
  });
}

TEST_F (PointCloud2Test, DataThatIsShorterThanItSaysIsAnError)
{
  const pcl::PCLPointCloud2 good = makeBinaryCloud ({}, points_);
  pcl::PCLPointCloud2 bad = good;
  bad.data.resize (bad.data.size () / 2);
  expectError (bad, std::to_string (bad.data.size ()));
  bad = good;
  bad.fields[2].offset = bad.point_step; // z would extend into the next point
  expectError (bad, "x, y, z");
  bad = good;
  bad.point_step = 0;
  expectError (bad, "x, y, z");
}
} // namespace
