// SPDX-License-Identifier: BSD-3-Clause
// WPCANormalEstimation and HoughNormalEstimation used by code that takes any pcl::Feature for normals. On a sphere they
// are about as good as PCL's estimation; near the edges of a cube, WPCA is slightly better and Hough much better.
#include <pcl_normal_smoothing/hough_normal_estimation.h>
#include <pcl_normal_smoothing/wpca_normal_estimation.h>

#include <pcl/features/normal_3d_omp.h>

#include <iostream>
#include <random>
#include <vector>

using NormalFeature = pcl::Feature<pcl::PointXYZ, pcl::Normal>;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

constexpr int size = 10000;
constexpr float noise = 0.002f;

/** A cloud and its true normals. */
struct Scan
{
  Cloud::Ptr cloud = pcl::make_shared<Cloud> ();
  std::vector<Eigen::Vector3f> normals;
  std::vector<std::size_t> judged; // points whose normals are compared

  void
  add (const Eigen::Vector3f& position, const Eigen::Vector3f& normal, bool judge)
  {
    if (judge)
      judged.push_back (cloud->size ());
    cloud->emplace_back (position.x (), position.y (), position.z ());
    normals.push_back (normal);
  }
};

/** A sphere of radius 1. */
Scan
scanSphere ()
{
  std::mt19937 random (1);
  std::normal_distribution<float> normal;
  Scan scan;
  for (int i = 0; i < size; ++i) {
    const Eigen::Vector3f direction = Eigen::Vector3f (normal (random), normal (random), normal (random)).normalized ();
    scan.add ((1 + noise * normal (random)) * direction, direction, true);
  }
  return scan;
}

/** A cube with edges of 1; only points whose neighbourhoods extend over an edge are judged. */
Scan
scanCube ()
{
  constexpr float near = 0.05f;
  std::mt19937 random (1);
  std::uniform_real_distribution<float> place;
  std::normal_distribution<float> normal;
  Scan scan;
  for (int i = 0; i < size; ++i) {
    const Eigen::Array2f on_face (place (random), place (random));
    const auto axis = static_cast<Eigen::Index> (i % 3);
    Eigen::Vector3f outward = Eigen::Vector3f::Zero (), position;
    outward[axis] = i % 2 == 0 ? -1.0f : 1.0f;
    position[axis] = i % 2 == 0 ? 0.0f : 1.0f;
    position[(axis + 1) % 3] = on_face[0];
    position[(axis + 2) % 3] = on_face[1];
    scan.add (position + noise * normal (random) * outward, outward, on_face.min (1 - on_face).minCoeff () < near);
  }
  return scan;
}

/** Mean angle between the estimated and the true normals, in degrees. */
double
meanAngle (const NormalFeature::Ptr& feature, const Scan& scan)
{
  pcl::PointCloud<pcl::Normal> normals;
  feature->setInputCloud (scan.cloud);
  feature->setKSearch (15);
  feature->compute (normals);
  if (normals.size () != scan.cloud->size ())
    return 90;
  double sum = 0;
  for (const std::size_t i : scan.judged)
    sum += std::acos (std::min (1.0f, std::abs (normals[i].getNormalVector3fMap ().dot (scan.normals[i]))));
  return sum / static_cast<double> (scan.judged.size ()) * 180 / M_PI;
}

struct Angles
{
  double pcl, wpca, hough;
};

Angles
compare (const std::string& where, const Scan& scan)
{
  using namespace pcl_normal_smoothing;
  const Angles angles {meanAngle (pcl::make_shared<pcl::NormalEstimationOMP<pcl::PointXYZ, pcl::Normal>> (), scan),
                       meanAngle (pcl::make_shared<WPCANormalEstimation<pcl::PointXYZ, pcl::Normal>> (), scan),
                       meanAngle (pcl::make_shared<HoughNormalEstimation<pcl::PointXYZ, pcl::Normal>> (), scan)};
  std::cout << "mean angle to the true normals " << where << ", in degrees: pcl::NormalEstimationOMP " << angles.pcl
            << ", WPCA " << angles.wpca << ", Hough " << angles.hough << "\n";
  return angles;
}

int
main ()
{
  const Angles of_sphere = compare ("of a sphere", scanSphere ()),
               beside_edges = compare ("beside the edges of a cube", scanCube ());
  const bool close = of_sphere.wpca < 5 && of_sphere.hough < 10;
  const bool better = beside_edges.wpca < beside_edges.pcl && beside_edges.hough < 0.85 * beside_edges.pcl;
  return close && better ? 0 : 1;
}
