// SPDX-License-Identifier: BSD-3-Clause
#define PCL_NO_PRECOMPILE
#include <pcl_normal_smoothing/bilateral_normal_filter.h>
#include <pcl_normal_smoothing/hough_normal_estimation.h>
#include <pcl_normal_smoothing/normal_guided_point_update.h>
#include <pcl_normal_smoothing/normal_smoothing.h>
#include <pcl_normal_smoothing/wpca_normal_estimation.h>

#include "../shapes.h"

#include <gtest/gtest.h>
#include <pcl/register_point_struct.h>

#include <cstring>
#include <memory>
#include <new>

/** A point type of a scanner: the normal precedes the position, and one field is in no type of PCL's. Copying it can be
  * made to fail, as copying a large cloud may. */
struct EIGEN_ALIGN16 ScannerPoint
{
  ScannerPoint () = default;

  ScannerPoint (const ScannerPoint& other)
  {
    *this = other;
  }

  ScannerPoint&
  operator= (const ScannerPoint& other)
  {
    if (memory_is_short)
      throw std::bad_alloc ();
    std::memcpy (static_cast<void*> (this), static_cast<const void*> (&other), sizeof other);
    return *this;
  }

  static inline bool memory_is_short = false;

  PCL_ADD_NORMAL4D;
  std::uint16_t ring;
  float curvature;
  PCL_ADD_POINT4D;
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};

POINT_CLOUD_REGISTER_POINT_STRUCT (ScannerPoint,
                                   (float, normal_x, normal_x) (float, normal_y, normal_y) (float, normal_z, normal_z) (
                                       std::uint16_t,
                                       ring,
                                       ring) (float, curvature, curvature) (float, x, x) (float, y, y) (float, z, z))

namespace
{
using namespace pcl_normal_smoothing;
using namespace test_support;
using Cloud = pcl::PointCloud<ScannerPoint>;

class CustomPointType : public testing::Test
{
protected:
  CustomPointType ()
  {
    const Shape shape = torus (300, 1, 0.4);
    const Vectors points = withNoise (shape.points, 0.03, 190);
    for (std::size_t i = 0; i < points.size (); ++i) {
      ScannerPoint point {};
      point.getVector4fMap () << points[i], 1;
      point.getNormalVector3fMap () = shape.normals[i];
      point.ring = static_cast<std::uint16_t> (i * 200);
      custom_->push_back (point);
      pcl::PointNormal known;
      known.getVector3fMap () = points[i];
      known.getNormalVector3fMap () = shape.normals[i];
      known_->push_back (known);
    }
  }

  /** Expects the precompiled class and the one compiled here to give the same results. */
  template <template <typename> class FilterTemplate>
  void
  expectSameAsKnownType () const
  {
    FilterTemplate<ScannerPoint> of_custom;
    FilterTemplate<pcl::PointNormal> of_known;
    of_custom.setInputCloud (custom_);
    of_known.setInputCloud (known_);
    of_custom.setKSearch (10);
    of_known.setKSearch (10);
    Cloud custom;
    pcl::PointCloud<pcl::PointNormal> known;
    of_custom.filter (custom);
    of_known.filter (known);
    ASSERT_EQ (of_custom.getErrorMessage (), "");
    ASSERT_EQ (custom.size (), known.size ());
    for (std::size_t i = 0; i < custom.size (); ++i) {
      EXPECT_EQ (custom[i].getVector3fMap (), known[i].getVector3fMap ()) << "point " << i;
      EXPECT_EQ (custom[i].getNormalVector3fMap (), known[i].getNormalVector3fMap ()) << "point " << i;
      EXPECT_EQ (custom[i].ring, (*custom_)[i].ring);
    }
  }

  /** Expects that filter () lets no exception escape. */
  template <template <typename> class FilterTemplate>
  void
  expectMessageWhereMemoryIsShort () const
  {
    FilterTemplate<ScannerPoint> filter;
    filter.setInputCloud (custom_);
    filter.setKSearch (10);
    Cloud output;
    ScannerPoint::memory_is_short = true;
    EXPECT_NO_THROW (filter.filter (output));
    ScannerPoint::memory_is_short = false;
    EXPECT_NE (filter.getErrorMessage ().find ("memory"), std::string::npos) << filter.getErrorMessage ();
    EXPECT_TRUE (output.empty ());
  }

  template <template <typename, typename> class FeatureTemplate>
  void
  expectSameNormals () const
  {
    FeatureTemplate<ScannerPoint, ScannerPoint> of_custom;
    FeatureTemplate<pcl::PointNormal, pcl::Normal> of_known;
    of_custom.setInputCloud (custom_);
    of_known.setInputCloud (known_);
    of_custom.setKSearch (10);
    of_known.setKSearch (10);
    Cloud custom;
    pcl::PointCloud<pcl::Normal> known;
    of_custom.compute (custom);
    of_known.compute (known);
    ASSERT_EQ (custom.size (), known.size ());
    for (std::size_t i = 0; i < custom.size (); ++i) {
      EXPECT_EQ (custom[i].getNormalVector3fMap (), known[i].getNormalVector3fMap ()) << "point " << i;
      EXPECT_EQ (custom[i].curvature, known[i].curvature) << "point " << i;
    }
  }

  Cloud::Ptr custom_ = std::make_shared<Cloud> ();
  pcl::PointCloud<pcl::PointNormal>::Ptr known_ = std::make_shared<pcl::PointCloud<pcl::PointNormal>> ();
};

TEST_F (CustomPointType, IsFilteredAsPclsOwn)
{
  expectSameAsKnownType<BilateralNormalFilter> ();
  expectSameAsKnownType<NormalGuidedPointUpdate> ();
  expectSameAsKnownType<NormalSmoothing> ();
}

TEST_F (CustomPointType, TooLittleMemoryForTheOutputIsAnError)
{
  expectMessageWhereMemoryIsShort<BilateralNormalFilter> ();
  expectMessageWhereMemoryIsShort<NormalGuidedPointUpdate> ();
  expectMessageWhereMemoryIsShort<NormalSmoothing> ();
}

TEST_F (CustomPointType, HasTheNormalsOfPclsOwn)
{
  expectSameNormals<WPCANormalEstimation> ();
  expectSameNormals<HoughNormalEstimation> ();
}
} // namespace
