// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "clouds.h"

#include <pcl_normal_smoothing/bilateral_normal_filter.h>
#include <pcl_normal_smoothing/normal_guided_point_update.h>
#include <pcl_normal_smoothing/normal_smoothing.h>

namespace test_support
{
template <typename FilterT>
struct FilterTraits;

template <template <typename> class FilterTemplate, typename PointT>
struct FilterTraits<FilterTemplate<PointT>>
{
  using Point = PointT;
  static constexpr bool writes_points =
      !std::is_same_v<FilterTemplate<PointT>, pcl_normal_smoothing::BilateralNormalFilter<PointT>>;
  static constexpr bool estimates_normals =
      std::is_same_v<FilterTemplate<PointT>, pcl_normal_smoothing::NormalSmoothing<PointT>>;
};

/** One of the three filters, on a noisy torus with noisy normals. */
template <typename FilterT>
class FilterTest : public testing::Test
{
protected:
  using Traits = FilterTraits<FilterT>;
  using Point = typename Traits::Point;
  using Cloud = pcl::PointCloud<Point>;
  using CloudPtr = typename Cloud::Ptr;
  static constexpr bool has_normal = pcl::traits::has_normal<Point>::value;

  FilterTest ()
  {
    const Shape shape = torus (300, 1, 0.4);
    points_ = withNoise (shape.points, 0.03, 100);
    normals_ = withRandomSigns (withNoise (shape.normals, 0.1, 101), 102);
    cloud_ = makeCloud<Point> (points_, normals_);
  }

  /** Sets everything that the filter needs except k.
    * \param[in] normals used if the points have none */
  static void
  prepare (FilterT& filter, const typename Cloud::ConstPtr& cloud, const Vectors& normals)
  {
    filter.setInputCloud (cloud);
    filter.setNumberOfThreads (2);
    if constexpr (!has_normal)
      filter.setInputNormals (makeNormals (normals));
  }

  void
  prepare (FilterT& filter) const
  {
    prepare (filter, cloud_, normals_);
    filter.setKSearch (10);
  }

  static Cloud
  run (FilterT& filter)
  {
    Cloud output = poisonedCloud<Point> ();
    filter.filter (output);
    EXPECT_EQ (filter.getErrorMessage (), "");
    EXPECT_FALSE (filter.wasCancelled ());
    return output;
  }

  /** Expects an error message that contains \a part, and an empty output. */
  static void
  expectError (FilterT& filter, const std::string& part)
  {
    Cloud output = poisonedCloud<Point> ();
    filter.filter (output);
    expectEmpty (output);
    EXPECT_TRUE (contains (filter.getErrorMessage (), part))
        << "'" << filter.getErrorMessage () << "' without " << part;
    EXPECT_FALSE (filter.wasCancelled ());
  }

  /** The filter's result for the whole cloud. */
  Cloud
  result () const
  {
    FilterT filter;
    prepare (filter);
    return run (filter);
  }

  Vectors points_;
  Vectors normals_;
  CloudPtr cloud_;
};

using AllFilters = testing::Types<pcl_normal_smoothing::BilateralNormalFilter<pcl::PointNormal>,
                                  pcl_normal_smoothing::BilateralNormalFilter<pcl::PointXYZINormal>,
                                  pcl_normal_smoothing::BilateralNormalFilter<pcl::PointXYZRGBNormal>,
                                  pcl_normal_smoothing::NormalGuidedPointUpdate<pcl::PointXYZ>,
                                  pcl_normal_smoothing::NormalGuidedPointUpdate<pcl::PointXYZI>,
                                  pcl_normal_smoothing::NormalGuidedPointUpdate<pcl::PointXYZRGB>,
                                  pcl_normal_smoothing::NormalGuidedPointUpdate<pcl::PointXYZRGBA>,
                                  pcl_normal_smoothing::NormalGuidedPointUpdate<pcl::PointNormal>,
                                  pcl_normal_smoothing::NormalGuidedPointUpdate<pcl::PointXYZINormal>,
                                  pcl_normal_smoothing::NormalGuidedPointUpdate<pcl::PointXYZRGBNormal>,
                                  pcl_normal_smoothing::NormalSmoothing<pcl::PointXYZ>,
                                  pcl_normal_smoothing::NormalSmoothing<pcl::PointXYZI>,
                                  pcl_normal_smoothing::NormalSmoothing<pcl::PointXYZRGB>,
                                  pcl_normal_smoothing::NormalSmoothing<pcl::PointXYZRGBA>,
                                  pcl_normal_smoothing::NormalSmoothing<pcl::PointNormal>,
                                  pcl_normal_smoothing::NormalSmoothing<pcl::PointXYZINormal>,
                                  pcl_normal_smoothing::NormalSmoothing<pcl::PointXYZRGBNormal>>;

/** Each filter once, with and without normals: for tests that do not depend on the other fields. */
using OneOfEachFilter = testing::Types<pcl_normal_smoothing::BilateralNormalFilter<pcl::PointNormal>,
                                       pcl_normal_smoothing::NormalGuidedPointUpdate<pcl::PointNormal>,
                                       pcl_normal_smoothing::NormalGuidedPointUpdate<pcl::PointXYZ>,
                                       pcl_normal_smoothing::NormalSmoothing<pcl::PointNormal>,
                                       pcl_normal_smoothing::NormalSmoothing<pcl::PointXYZ>>;
} // namespace test_support
