// SPDX-License-Identifier: BSD-3-Clause
#include "searches.h"

#include <pcl_normal_smoothing/surface_noise_estimation.h>

#include <gtest/gtest.h>

#include <limits>

namespace
{
using namespace pcl_normal_smoothing;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

constexpr float spacing = 0.01f;
constexpr double sigma = 0.2 * 0.01;

/** A cloud of the shape's points, with noise along its normals. */
Cloud::Ptr
withNoise (const test_support::Shape& plane)
{
  auto cloud = pcl::make_shared<Cloud> ();
  for (const Eigen::Vector3f& point : test_support::withNormalNoise (plane, sigma, 1))
    cloud->emplace_back (point.x (), point.y (), point.z ());
  return cloud;
}

Cloud::Ptr
noisyPlane ()
{
  return withNoise (test_support::planeGrid (60, spacing));
}

TEST (SurfaceNoiseEstimationTest, ReadsNoiseAndSpacing)
{
  SurfaceNoiseEstimation<pcl::PointXYZ> noise;
  noise.setInputCloud (noisyPlane ());
  ASSERT_TRUE (noise.compute ()) << noise.getErrorMessage ();
  EXPECT_NEAR (noise.getSigma (), sigma, 0.3 * sigma);
  EXPECT_NEAR (noise.getSpacing (), spacing, 0.2 * spacing);
}

TEST (SurfaceNoiseEstimationTest, TellsWhereTheNoiseIsLarge)
{
  for (const float unit : {1.0f, 0x1p60f, 0x1p-60f}) {
    const test_support::Shape plane = test_support::planeGrid (80, spacing);
    auto cloud = pcl::make_shared<Cloud> ();
    for (std::size_t i = 0; i < plane.size (); ++i) {
      const Eigen::Vector3f& place = plane.points[i];
      const float noise = (0.0005f + 0.004f * place.x ()) * static_cast<float> (test_support::gaussianNoise (1, i));
      cloud->emplace_back (unit * place.x (), unit * place.y (), unit * (place.z () + noise));
    }
    SurfaceNoiseEstimation<pcl::PointXYZ> noise;
    noise.setInputCloud (cloud);
    ASSERT_TRUE (noise.compute ()) << noise.getErrorMessage ();
    for (const float x : {0.2f, 0.4f, 0.7f})
      EXPECT_NEAR (noise.getSigmaAt ({unit * x, unit * 0.4f, 0}) / unit, 0.0005 + 0.004 * x, 0.0008) << x;
  }
  EXPECT_EQ (SurfaceNoiseEstimation<pcl::PointXYZ> ().getSigmaAt ({1, 2, 3}), 0);
}

TEST (SurfaceNoiseEstimationTest, IndexedPointsAloneAreTheCloud)
{
  const Cloud::Ptr cloud = noisyPlane ();
  const std::size_t size = cloud->size ();
  auto indices = pcl::make_shared<pcl::Indices> ();
  for (std::size_t i = 0; i < size; ++i) { // add a clean plane above the noisy one
    indices->push_back (static_cast<pcl::index_t> (cloud->size ()));
    cloud->emplace_back ((*cloud)[i].x, (*cloud)[i].y, 1.0f);
  }
  SurfaceNoiseEstimation<pcl::PointXYZ> noise;
  noise.setInputCloud (cloud);
  noise.setIndices (indices);
  ASSERT_TRUE (noise.compute ()) << noise.getErrorMessage ();
  EXPECT_LT (noise.getSigma (), 0.01 * sigma);
}

/** Every third point of a cloud. */
pcl::IndicesPtr
everyThird (const Cloud& cloud)
{
  auto indices = pcl::make_shared<pcl::Indices> ();
  for (std::size_t i = 0; i < cloud.size (); i += 3)
    indices->push_back (static_cast<pcl::index_t> (i));
  return indices;
}

TEST (SurfaceNoiseEstimationTest, IndexedPointsAreSearchedByEverySearch)
{
  const Cloud::Ptr cloud = noisyPlane ();
  const pcl::IndicesPtr indices = everyThird (*cloud);
  auto searches = test_support::userSearches<pcl::PointXYZ> ();
  searches.push_back (nullptr); // the module's own search
  for (const auto& search : searches) {
    SurfaceNoiseEstimation<pcl::PointXYZ> of_indexed, alone;
    of_indexed.setInputCloud (cloud);
    of_indexed.setIndices (indices);
    alone.setInputCloud (pcl::make_shared<Cloud> (*cloud, *indices));
    for (auto* noise : {&of_indexed, &alone}) {
      noise->setSearchMethod (search);
      ASSERT_TRUE (noise->compute ()) << noise->getErrorMessage ();
    }
    EXPECT_EQ (of_indexed.getSigma (), alone.getSigma ());
    EXPECT_EQ (of_indexed.getSpacing (), alone.getSpacing ());
  }
}

TEST (SurfaceNoiseEstimationTest, AGraphOfAllPointsIsRefusedWhereSomeAreIndexed)
{
  const Cloud::Ptr cloud = noisyPlane ();
  SurfaceNoiseEstimation<pcl::PointXYZ> noise;
  noise.setInputCloud (cloud);
  noise.setNeighborGraph (buildNeighborGraph<pcl::PointXYZ> (cloud, 16));
  ASSERT_TRUE (noise.compute ()) << noise.getErrorMessage ();
  const double expected = noise.getSigma ();
  noise.setIndices (everyThird (*cloud));
  EXPECT_FALSE (noise.compute ());
  EXPECT_NE (noise.getErrorMessage ().find ("setIndices"), std::string::npos) << noise.getErrorMessage ();
  EXPECT_NE (noise.getErrorMessage ().find ("2400 of 3600"), std::string::npos) << noise.getErrorMessage ();
  auto all = pcl::make_shared<pcl::Indices> ();
  for (std::size_t i = cloud->size (); i-- > 0;)
    all->push_back (static_cast<pcl::index_t> (i));
  cloud->emplace_back (std::numeric_limits<float>::quiet_NaN (), 0.0f, 0.0f); // not indexed
  noise.setNeighborGraph (buildNeighborGraph<pcl::PointXYZ> (cloud, 16));
  noise.setInputCloud (cloud);
  noise.setIndices (all);
  ASSERT_TRUE (noise.compute ()) << noise.getErrorMessage ();
  EXPECT_EQ (noise.getSigma (), expected);
}

TEST (SurfaceNoiseEstimationTest, PointsThatAreNotFiniteDoNotCount)
{
  const Cloud::Ptr cloud = noisyPlane ();
  SurfaceNoiseEstimation<pcl::PointXYZ> noise;
  noise.setInputCloud (cloud);
  ASSERT_TRUE (noise.compute ()) << noise.getErrorMessage ();
  const double expected = noise.getSigma ();
  for (const bool is_dense : {true, false}) {
    const float nan = std::numeric_limits<float>::quiet_NaN (), infinity = std::numeric_limits<float>::infinity ();
    cloud->emplace_back (0.0f, nan, 0.0f);
    cloud->emplace_back (infinity, 0.0f, 0.0f);
    cloud->is_dense = is_dense;
    ASSERT_TRUE (noise.compute ()) << noise.getErrorMessage ();
    EXPECT_EQ (noise.getSigma (), expected);
  }
}

TEST (SurfaceNoiseEstimationTest, IsInTheCloudsUnit)
{
  const Cloud::Ptr cloud = noisyPlane ();
  SurfaceNoiseEstimation<pcl::PointXYZ> noise;
  noise.setInputCloud (cloud);
  ASSERT_TRUE (noise.compute ()) << noise.getErrorMessage ();
  for (const float scale : {0x1p-100f, 1e-30f, 1e30f, 0x1p100f}) {
    auto scaled = pcl::make_shared<Cloud> (*cloud);
    for (auto& point : *scaled)
      point.getVector3fMap () *= scale;
    SurfaceNoiseEstimation<pcl::PointXYZ> of_scaled;
    of_scaled.setInputCloud (scaled);
    ASSERT_TRUE (of_scaled.compute ()) << of_scaled.getErrorMessage ();
    EXPECT_NEAR (of_scaled.getSigma () / scale, noise.getSigma (), 1e-3 * noise.getSigma ()) << scale;
    EXPECT_NEAR (of_scaled.getSpacing () / scale, noise.getSpacing (), 1e-3 * noise.getSpacing ()) << scale;
  }
}

TEST (SurfaceNoiseEstimationTest, CopiedAndReusedItGivesTheSame)
{
  SurfaceNoiseEstimation<pcl::PointXYZ> noise;
  noise.setInputCloud (noisyPlane ());
  ASSERT_TRUE (noise.compute ()) << noise.getErrorMessage ();
  const double expected = noise.getSigma ();
  SurfaceNoiseEstimation<pcl::PointXYZ> copy (noise);
  noise.setInputCloud (withNoise (test_support::planeGrid (20, 1)));
  ASSERT_TRUE (noise.compute ()) << noise.getErrorMessage ();
  EXPECT_NE (noise.getSigma (), expected);
  for (const unsigned threads : {1u, 3u}) {
    copy.setNumberOfThreads (threads);
    ASSERT_TRUE (copy.compute ()) << copy.getErrorMessage ();
    EXPECT_EQ (copy.getSigma (), expected);
  }
  copy.setProgressCallback ([] (double) { return false; });
  EXPECT_FALSE (copy.compute ());
  EXPECT_TRUE (copy.wasCancelled ());
  EXPECT_EQ (copy.getSigma (), 0);
}

TEST (SurfaceNoiseEstimationTest, BadInputIsAnErrorAndGivesZero)
{
  SurfaceNoiseEstimation<pcl::PointXYZ> noise;
  EXPECT_FALSE (noise.compute ());
  EXPECT_FALSE (noise.getErrorMessage ().empty ());
  auto cloud = pcl::make_shared<Cloud> ();
  cloud->emplace_back (std::numeric_limits<float>::quiet_NaN (), 0.0f, 0.0f);
  noise.setInputCloud (cloud);
  EXPECT_FALSE (noise.compute ());
  EXPECT_EQ (noise.getSigma (), 0);
  EXPECT_EQ (noise.getSpacing (), 0);
}
} // namespace
