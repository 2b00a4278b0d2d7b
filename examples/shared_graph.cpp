// SPDX-License-Identifier: BSD-3-Clause
// The three stages one by one, on a neighbour graph that is built once: for a NormalSmoothing of your own.
#include <pcl_normal_smoothing/bilateral_normal_filter.h>
#include <pcl_normal_smoothing/neighbor_graph.h>
#include <pcl_normal_smoothing/normal_guided_point_update.h>
#include <pcl_normal_smoothing/wpca_normal_estimation.h>

#include <iostream>
#include <random>

using PointT = pcl::PointXYZ;
using Cloud = pcl::PointCloud<PointT>;
using Normals = pcl::PointCloud<pcl::Normal>;

/** A right-angled edge, z = -|x|, with noise of 0.003; a point about every 0.02. */
Cloud::Ptr
makeEdge ()
{
  std::mt19937 random (1);
  std::normal_distribution<float> noise (0, 0.003f);
  auto cloud = pcl::make_shared<Cloud> ();
  for (int i = -50; i <= 50; ++i)
    for (int j = 0; j < 100; ++j) {
      const float x = 0.0141421f * static_cast<float> (i);
      cloud->emplace_back (x, 0.02f * static_cast<float> (j), noise (random) - std::abs (x));
    }
  return cloud;
}

double
meanDistanceToEdge (const Cloud& cloud)
{
  double sum = 0;
  for (const PointT& point : cloud)
    sum += std::abs (point.z + std::abs (point.x)) * M_SQRT1_2;
  return sum / static_cast<double> (cloud.size ());
}

/** Estimates, filters and updates with the same neighbourhoods; empty if a stage fails. */
Cloud
smoothInStages (const Cloud::ConstPtr& cloud)
{
  const auto graph = pcl_normal_smoothing::buildNeighborGraph<PointT> (cloud, 15);

  auto estimated = pcl::make_shared<Normals> ();
  pcl_normal_smoothing::WPCANormalEstimation<PointT, pcl::Normal> estimation;
  estimation.setInputCloud (cloud);
  estimation.setNeighborGraph (graph);
  estimation.compute (*estimated);

  auto filtered = pcl::make_shared<Normals> ();
  pcl_normal_smoothing::BilateralNormalFilter<PointT> filter;
  filter.setInputCloud (cloud);
  filter.setInputNormals (estimated);
  filter.setNeighborGraph (graph);
  filter.setMaxIterations (4);
  filter.filterNormals (*filtered);

  Cloud smoothed;
  pcl_normal_smoothing::NormalGuidedPointUpdate<PointT> update;
  update.setInputCloud (cloud);
  update.setInputNormals (filtered);
  update.setNeighborGraph (graph);
  update.setMaxIterations (2);
  update.filter (smoothed);
  return smoothed;
}

int
main ()
{
  const Cloud::ConstPtr noisy = makeEdge ();
  const Cloud smoothed = smoothInStages (noisy);
  const double before = meanDistanceToEdge (*noisy), after = meanDistanceToEdge (smoothed);
  std::cout << "mean distance to the edge: " << before << " before, " << after << " after\n";
  return smoothed.size () == noisy->size () && after < 0.7 * before ? 0 : 1;
}
