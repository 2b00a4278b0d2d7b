// SPDX-License-Identifier: BSD-3-Clause
// Region growing by normals finds the three sides of a noisy corner once it is smoothed.
#include <pcl_normal_smoothing/normal_smoothing.h>

#include <pcl/features/normal_3d_omp.h>
#include <pcl/segmentation/region_growing.h>

#include <iostream>
#include <random>

using PointT = pcl::PointXYZ;
using Cloud = pcl::PointCloud<PointT>;

constexpr std::size_t side_size = 2500;

/** Three sides of a cube of edge 1, 2500 points each, with noise of 0.01: half of their spacing. */
Cloud::Ptr
makeCorner ()
{
  std::mt19937 random (1);
  std::uniform_real_distribution<float> place (0, 1);
  std::normal_distribution<float> noise (0, 0.01f);
  auto corner = pcl::make_shared<Cloud> ();
  for (int side = 0; side < 3; ++side)
    for (std::size_t i = 0; i < side_size; ++i) {
      Eigen::Vector3f position (place (random), place (random), place (random));
      position[side] = noise (random);
      corner->emplace_back (position.x (), position.y (), position.z ());
    }
  return corner;
}

/** \return share of the points that are in the largest region of their side */
double
shareFound (const Cloud::ConstPtr& cloud)
{
  auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>> ();
  pcl::NormalEstimationOMP<PointT, pcl::Normal> estimation;
  estimation.setInputCloud (cloud);
  estimation.setKSearch (16);
  estimation.compute (*normals);

  pcl::RegionGrowing<PointT, pcl::Normal> growing;
  growing.setInputCloud (cloud);
  growing.setInputNormals (normals);
  growing.setSearchMethod (pcl::make_shared<pcl::search::KdTree<PointT>> ());
  growing.setNumberOfNeighbours (16);
  growing.setMinClusterSize (100);
  growing.setSmoothnessThreshold (static_cast<float> (8 * M_PI / 180));
  growing.setCurvatureThreshold (0.05f);
  std::vector<pcl::PointIndices> regions;
  growing.extract (regions);

  std::size_t found[3] = {};
  for (const pcl::PointIndices& region : regions) {
    std::size_t of_side[3] = {};
    for (const auto i : region.indices)
      ++of_side[static_cast<std::size_t> (i) / side_size];
    const auto side = std::max_element (of_side, of_side + 3) - of_side; // points of other sides in it do not count
    found[side] = std::max (found[side], of_side[side]);
  }
  return static_cast<double> (found[0] + found[1] + found[2]) / static_cast<double> (cloud->size ());
}

int
main ()
{
  const Cloud::ConstPtr corner = makeCorner ();
  auto smoothed = pcl::make_shared<Cloud> ();
  pcl_normal_smoothing::NormalSmoothing<PointT> smoothing;
  smoothing.setInputCloud (corner);
  smoothing.filter (*smoothed);
  const double before = shareFound (corner), after = shareFound (smoothed);
  std::cout << "in the right region: " << 100 * before << " % raw, " << 100 * after << " % smoothed\n";
  return after > 0.8 && after > before + 0.2 ? 0 : 1;
}
