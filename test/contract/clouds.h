// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../shapes.h"
#include "../text.h"

#include <gtest/gtest.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <array>
#include <cstring>
#include <limits>
#include <memory>
#include <thread>

namespace test_support
{
constexpr float nan_float = std::numeric_limits<float>::quiet_NaN ();
using NormalCloud = pcl::PointCloud<pcl::Normal>;

/** A point whose fields all depend on its number; its padding is zero, so that points can be compared byte by byte. */
template <typename PointT>
PointT
makePoint (const Eigen::Vector3f& position, const Eigen::Vector3f& normal, std::size_t i)
{
  PointT point;
  std::memset (static_cast<void*> (&point), 0, sizeof point);
  point.getVector4fMap () << position, 1.0f;
  if constexpr (pcl::traits::has_normal<PointT>::value) {
    point.getNormalVector3fMap () = normal;
    point.curvature = 0.25f + static_cast<float> (i);
  }
  if constexpr (pcl::traits::has_intensity<PointT>::value)
    point.intensity = 0.5f + static_cast<float> (i);
  if constexpr (pcl::traits::has_color<PointT>::value)
    point.rgba = 0x80000000u + static_cast<std::uint32_t> (i) * 2654435761u;
  return point;
}

/** A cloud with a header and a sensor pose that differ from the defaults. */
template <typename PointT>
typename pcl::PointCloud<PointT>::Ptr
makeCloud (const Vectors& points, const Vectors& normals)
{
  auto cloud = std::make_shared<pcl::PointCloud<PointT>> ();
  for (std::size_t i = 0; i < points.size (); ++i)
    cloud->push_back (makePoint<PointT> (points[i], normals[i], i));
  cloud->header.frame_id = "scanner";
  cloud->header.stamp = 1234567;
  cloud->header.seq = 42;
  cloud->sensor_origin_ = Eigen::Vector4f (0.5f, -0.25f, 8, 0);
  cloud->sensor_orientation_ = Eigen::Quaternionf (0, 1, 0, 0);
  return cloud;
}

inline NormalCloud::Ptr
makeNormals (const Vectors& normals)
{
  auto cloud = std::make_shared<NormalCloud> ();
  for (const auto& normal : normals)
    cloud->push_back (pcl::Normal (normal.x (), normal.y (), normal.z ()));
  return cloud;
}

/** Arbitrary contents of an output before it is written, of which nothing may remain. */
template <typename PointT>
pcl::PointCloud<PointT>
poisonedCloud ()
{
  pcl::PointCloud<PointT> cloud;
  PointT point;
  std::memset (static_cast<void*> (&point), 0xFF, sizeof point); // every float is NaN
  cloud.resize (3, point);
  cloud.header.frame_id = "poison";
  cloud.is_dense = false;
  return cloud;
}

template <typename PointT>
bool
samePoint (const PointT& a, const PointT& b)
{
  return std::memcmp (static_cast<const void*> (&a), static_cast<const void*> (&b), sizeof a) == 0;
}

template <typename PointT>
void
expectSamePoints (const pcl::PointCloud<PointT>& actual, const pcl::PointCloud<PointT>& expected)
{
  ASSERT_EQ (actual.size (), expected.size ());
  for (std::size_t i = 0; i < expected.size (); ++i)
    ASSERT_TRUE (samePoint (actual[i], expected[i])) << "point " << i << " is " << actual[i] << ", not " << expected[i];
}

/** Compares everything but the points. */
template <typename PointT, typename OtherT>
void
expectSameFrame (const pcl::PointCloud<PointT>& actual, const pcl::PointCloud<OtherT>& expected)
{
  EXPECT_EQ (actual.width, expected.width);
  EXPECT_EQ (actual.height, expected.height);
  EXPECT_EQ (actual.is_dense, expected.is_dense);
  EXPECT_EQ (actual.header, expected.header);
  EXPECT_EQ (actual.sensor_origin_, expected.sensor_origin_);
  EXPECT_TRUE (actual.sensor_orientation_.isApprox (expected.sensor_orientation_));
}

template <typename PointT>
void
expectEmpty (const pcl::PointCloud<PointT>& cloud)
{
  EXPECT_TRUE (cloud.empty ());
  EXPECT_EQ (cloud.width * cloud.height, 0u);
}

/** The results of two simultaneous runs, each in its own thread. \param[in] run returns a cloud */
template <typename Run>
auto
resultsOfTwoThreads (const Run& run)
{
  std::array<decltype (run ()), 2> results;
  std::thread other ([&] { results[0] = run (); });
  results[1] = run ();
  other.join ();
  return results;
}
} // namespace test_support
