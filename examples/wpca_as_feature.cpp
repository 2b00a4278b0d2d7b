// SPDX-License-Identifier: BSD-3-Clause
// WPCANormalEstimation and HoughNormalEstimation where code takes any pcl::Feature that writes normals.
#include <pcl_normal_smoothing/hough_normal_estimation.h>
#include <pcl_normal_smoothing/wpca_normal_estimation.h>

#include <pcl/features/normal_3d_omp.h>

#include <iostream>
#include <random>

using NormalFeature = pcl::Feature<pcl::PointXYZ, pcl::Normal>;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/** A sphere of radius 1 with noise of 0.002. */
Cloud::Ptr
makeSphere ()
{
  std::mt19937 random (1);
  std::normal_distribution<float> normal;
  auto cloud = pcl::make_shared<Cloud> ();
  for (int i = 0; i < 10000; ++i) {
    const Eigen::Vector3f direction = Eigen::Vector3f (normal (random), normal (random), normal (random)).normalized ();
    const Eigen::Vector3f position = (1 + 0.002f * normal (random)) * direction;
    cloud->emplace_back (position.x (), position.y (), position.z ());
  }
  return cloud;
}

/** Mean angle between the normals and those of the sphere, in degrees. */
double
meanAngle (const NormalFeature::Ptr& feature, const Cloud::ConstPtr& cloud)
{
  pcl::PointCloud<pcl::Normal> normals;
  feature->setInputCloud (cloud);
  feature->setKSearch (15);
  feature->compute (normals);
  if (normals.size () != cloud->size ())
    return 90;
  double sum = 0;
  for (std::size_t i = 0; i < cloud->size (); ++i) {
    const Eigen::Vector3f truth = (*cloud)[i].getVector3fMap ().normalized ();
    const float cosine = std::abs (normals[i].getNormalVector3fMap ().dot (truth));
    sum += std::acos (std::min (1.0f, cosine));
  }
  return sum / static_cast<double> (cloud->size ()) * 180 / M_PI;
}

int
main ()
{
  const Cloud::ConstPtr sphere = makeSphere ();
  const double pcl_angle =
      meanAngle (pcl::make_shared<pcl::NormalEstimationOMP<pcl::PointXYZ, pcl::Normal>> (), sphere);
  using pcl_normal_smoothing::HoughNormalEstimation;
  using pcl_normal_smoothing::WPCANormalEstimation;
  const double wpca_angle = meanAngle (pcl::make_shared<WPCANormalEstimation<pcl::PointXYZ, pcl::Normal>> (), sphere);
  const double hough_angle = meanAngle (pcl::make_shared<HoughNormalEstimation<pcl::PointXYZ, pcl::Normal>> (), sphere);
  std::cout << "mean angle to the true normals, in degrees: pcl::NormalEstimationOMP " << pcl_angle << ", WPCA "
            << wpca_angle << ", Hough " << hough_angle << "\n";
  return wpca_angle < 5 && hough_angle < 10 ? 0 : 1;
}
