// SPDX-License-Identifier: BSD-3-Clause
// Three filters in a chain that only knows them as pcl::Filter: thin out, remove outliers, smooth; then normals are
// estimated. Colours are kept.
#include <pcl_normal_smoothing/normal_smoothing.h>

#include <pcl/features/normal_3d_omp.h>
#include <pcl/filters/statistical_outlier_removal.h>
#include <pcl/filters/voxel_grid.h>

#include <iostream>
#include <random>

using PointT = pcl::PointXYZRGB;
using Cloud = pcl::PointCloud<PointT>;

/** Half red, half blue sphere of radius 1 with noise of 0.01, and points far from it. */
Cloud::Ptr
makeScan ()
{
  std::mt19937 random (1);
  std::normal_distribution<float> normal;
  auto cloud = pcl::make_shared<Cloud> ();
  for (int i = 0; i < 40000; ++i) {
    const Eigen::Vector3f direction = Eigen::Vector3f (normal (random), normal (random), normal (random)).normalized ();
    const float radius = i % 2000 == 0 ? 2.0f : 1 + 0.01f * normal (random);
    PointT point;
    point.getVector3fMap () = radius * direction;
    (point.x < 0 ? point.r : point.b) = 255;
    cloud->push_back (point);
  }
  return cloud;
}

double
meanDistanceToSphere (const Cloud& cloud)
{
  double sum = 0;
  for (const PointT& point : cloud)
    sum += std::abs (point.getVector3fMap ().norm () - 1);
  return sum / static_cast<double> (cloud.size ());
}

/** Mean angle between the normals that PCA finds and the sphere's, in degrees. */
double
meanNormalError (const Cloud::ConstPtr& cloud)
{
  pcl::NormalEstimationOMP<PointT, pcl::Normal> estimation;
  estimation.setInputCloud (cloud);
  estimation.setKSearch (15);
  pcl::PointCloud<pcl::Normal> normals;
  estimation.compute (normals);
  double sum = 0;
  for (std::size_t i = 0; i < cloud->size (); ++i) {
    const Eigen::Vector3f truth = (*cloud)[i].getVector3fMap ().normalized ();
    sum += std::acos (std::min (std::abs (normals[i].getNormalVector3fMap ().dot (truth)), 1.0f)) * 180 / M_PI;
  }
  return sum / static_cast<double> (cloud->size ());
}

std::vector<pcl::Filter<PointT>::Ptr>
makeChain ()
{
  auto voxel_grid = pcl::make_shared<pcl::VoxelGrid<PointT>> ();
  voxel_grid->setLeafSize (0.03f, 0.03f, 0.03f);
  auto outlier_removal = pcl::make_shared<pcl::StatisticalOutlierRemoval<PointT>> ();
  outlier_removal->setMeanK (20);
  outlier_removal->setStddevMulThresh (3);
  auto smoothing = pcl::make_shared<pcl_normal_smoothing::NormalSmoothing<PointT>> ();
  smoothing->setKSearch (20);
  return {voxel_grid, outlier_removal, smoothing};
}

int
main ()
{
  Cloud::Ptr cloud = makeScan ();
  std::size_t before_smoothing = 0;
  double error_before = 0, angle_before = 0;
  for (const auto& filter : makeChain ()) {
    before_smoothing = cloud->size ();
    error_before = meanDistanceToSphere (*cloud);
    angle_before = meanNormalError (cloud);
    auto filtered = pcl::make_shared<Cloud> ();
    filter->setInputCloud (cloud);
    filter->filter (*filtered);
    cloud = filtered;
    std::cout << cloud->size () << " points, mean distance to the sphere " << meanDistanceToSphere (*cloud) << "\n";
  }

  const double angle = meanNormalError (cloud);
  std::cout << "normals " << angle_before << " degrees off before smoothing, " << angle << " after\n";
  const bool colored = std::all_of (cloud->begin (), cloud->end (), [] (const PointT& point) {
    return std::abs (point.x) < 0.1f || (point.r > point.b) == (point.x < 0);
  });
  const bool smoother = meanDistanceToSphere (*cloud) < 0.7 * error_before;
  return colored && smoother && angle < 0.7 * angle_before && cloud->size () == before_smoothing ? 0 : 1;
}
