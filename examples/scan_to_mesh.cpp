// SPDX-License-Identifier: BSD-3-Clause
// From a raw scan to a mesh: smoothing, which also gives normals, then greedy triangulation. doc/tutorial.md explains
// it. usage: scan_to_mesh [scan.pcd|ply mesh.ply]; without files: a scan of waves, whose mesh is judged
#include <pcl_normal_smoothing/normal_smoothing.h>
#include <pcl_normal_smoothing/surface_noise_estimation.h>

#include <pcl/common/io.h>
#include <pcl/features/normal_3d.h>
#include <pcl/io/auto_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/surface/gp3.h>

#include <iostream>
#include <random>

using PointT = pcl::PointNormal;
using Cloud = pcl::PointCloud<PointT>;

constexpr double longest_edge = 5; // of a triangle, in spacings

/** The distance between neighbouring points. */
double
spacingOf (const Cloud::ConstPtr& scan)
{
  pcl_normal_smoothing::SurfaceNoiseEstimation<PointT> noise;
  noise.setInputCloud (scan);
  noise.compute ();
  return noise.getSpacing ();
}

Cloud::Ptr
smooth (const Cloud::ConstPtr& scan)
{
  auto smoothed = pcl::make_shared<Cloud> ();
  pcl_normal_smoothing::NormalSmoothing<PointT> smoothing;
  smoothing.setInputCloud (scan);
  smoothing.filter (*smoothed);
  // The sign of a normal is arbitrary: turn it towards the scanner.
  for (PointT& point : *smoothed)
    pcl::flipNormalTowardsViewpoint (point, scan->sensor_origin_.x (), scan->sensor_origin_.y (),
                                     scan->sensor_origin_.z (), point.normal_x, point.normal_y, point.normal_z);
  return smoothed;
}

/** \param[in] radius longest edge, in the cloud's unit */
pcl::PolygonMesh
triangulate (const Cloud::ConstPtr& cloud, double radius)
{
  pcl::GreedyProjectionTriangulation<PointT> triangulation;
  triangulation.setInputCloud (cloud);
  triangulation.setSearchRadius (radius);
  triangulation.setMu (2.5);
  triangulation.setMaximumNearestNeighbors (100);
  pcl::PolygonMesh mesh;
  triangulation.reconstruct (mesh);
  return mesh;
}

/** A scan of z = 0.1 sin 4x cos 4y from above, with a point about every 0.02 and noise of 0.004. */
Cloud::Ptr
makeScan ()
{
  std::mt19937 random (1);
  std::uniform_real_distribution<float> place (-1, 1);
  std::normal_distribution<float> noise (0, 0.004f);
  auto scan = pcl::make_shared<Cloud> ();
  for (int i = 0; i < 10000; ++i) {
    PointT point;
    point.x = place (random);
    point.y = place (random);
    point.z = 0.1f * std::sin (4 * point.x) * std::cos (4 * point.y) + noise (random);
    scan->push_back (point);
  }
  scan->sensor_origin_ = Eigen::Vector4f (0, 0, 10, 0);
  return scan;
}

/** Mean angle between the triangles and the waves, in degrees. */
double
meanAngle (const pcl::PolygonMesh& mesh, const Cloud& cloud)
{
  double sum = 0;
  for (const pcl::Vertices& face : mesh.polygons) {
    const auto corner = [&] (std::size_t i) -> Eigen::Vector3d {
      return cloud[face.vertices[i]].getVector3fMap ().cast<double> ();
    };
    const Eigen::Vector3d a = corner (0), b = corner (1), c = corner (2), middle = (a + b + c) / 3;
    const Eigen::Vector3d truth (-0.4 * std::cos (4 * middle.x ()) * std::cos (4 * middle.y ()),
                                 0.4 * std::sin (4 * middle.x ()) * std::sin (4 * middle.y ()), 1);
    const double cosine = std::abs ((b - a).cross (c - a).normalized ().dot (truth.normalized ()));
    sum += std::acos (std::min (cosine, 1.0)) * 180 / M_PI;
  }
  return sum / static_cast<double> (mesh.polygons.size ());
}

int
meshFile (const std::string& scan_file, const std::string& mesh_file)
{
  pcl::PointCloud<pcl::PointXYZ> loaded;      // without normals: smoothing gives them
  if (pcl::io::load (scan_file, loaded) != 0) // it has printed what is wrong
    return 1;
  auto scan = pcl::make_shared<Cloud> ();
  pcl::copyPointCloud (loaded, *scan);
  const pcl::PolygonMesh mesh = triangulate (smooth (scan), longest_edge * spacingOf (scan));
  std::cout << mesh.polygons.size () << " triangles\n";
  return !mesh.polygons.empty () && pcl::io::savePLYFileBinary (mesh_file, mesh) == 0 ? 0 : 1;
}

int
main (int argc, char** argv)
{
  if (argc == 3)
    return meshFile (argv[1], argv[2]);
  const Cloud::ConstPtr scan = makeScan (), smoothed = smooth (scan);
  const double radius = longest_edge * spacingOf (scan);
  auto noisy = pcl::make_shared<Cloud> (*smoothed); // the same normals, so that only the positions differ
  for (std::size_t i = 0; i < scan->size (); ++i)
    (*noisy)[i].getVector3fMap () = (*scan)[i].getVector3fMap ();
  const pcl::PolygonMesh before = triangulate (noisy, radius), after = triangulate (smoothed, radius);
  const double angle_before = meanAngle (before, *noisy), angle_after = meanAngle (after, *smoothed);
  std::cout << before.polygons.size () << " triangles, " << angle_before
            << " degrees off; smoothed: " << after.polygons.size () << ", " << angle_after << " degrees off\n";
  return angle_after < 0.5 * angle_before ? 0 : 1;
}
