// SPDX-License-Identifier: BSD-3-Clause
#include "clouds.h"

#include <pcl_normal_smoothing/normal_smoothing.h>

#include <pcl/filters/statistical_outlier_removal.h>
#include <pcl/filters/voxel_grid.h>

#include <cmath>

namespace
{
using namespace test_support;
using Cloud = pcl::PointCloud<pcl::PointXYZRGB>;

double
distanceToSphere (const Cloud& cloud)
{
  double sum = 0;
  for (const auto& point : cloud)
    sum += std::abs (point.getVector3fMap ().norm () - 1);
  return sum / static_cast<double> (cloud.size ());
}

TEST (Chain, SmoothingFollowsPclsFiltersAsOneOfThem)
{
  const Shape ball = sphere (6000, 1);
  Vectors points = withNoise (ball.points, 0.01, 180);
  points[77] *= 3; // an outlier
  Cloud::Ptr cloud = makeCloud<pcl::PointXYZRGB> (points, ball.normals);

  auto grid = std::make_shared<pcl::VoxelGrid<pcl::PointXYZRGB>> ();
  grid->setLeafSize (0.06f, 0.06f, 0.06f);
  auto outliers = std::make_shared<pcl::StatisticalOutlierRemoval<pcl::PointXYZRGB>> ();
  outliers->setMeanK (10);
  outliers->setStddevMulThresh (3);
  const auto smoothing = std::make_shared<pcl_normal_smoothing::NormalSmoothing<pcl::PointXYZRGB>> ();
  const std::vector<pcl::Filter<pcl::PointXYZRGB>::Ptr> chain {grid, outliers, smoothing};
  std::vector<Cloud::Ptr> stages {cloud};
  for (const auto& filter : chain) {
    filter->setInputCloud (stages.back ());
    stages.push_back (std::make_shared<Cloud> ());
    filter->filter (*stages.back ());
  }

  EXPECT_EQ (smoothing->getErrorMessage (), "");
  const Cloud &input = *stages[2], &output = *stages[3];
  ASSERT_GT (input.size (), 1000u);
  ASSERT_EQ (output.size (), input.size ());
  EXPECT_EQ (output.header, input.header);
  for (std::size_t i = 0; i < input.size (); ++i)
    EXPECT_EQ (output[i].rgba, input[i].rgba) << "point " << i;
  EXPECT_LT (distanceToSphere (output), 0.75 * distanceToSphere (input));
}
} // namespace
