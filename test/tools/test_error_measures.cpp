// SPDX-License-Identifier: BSD-3-Clause
#include "meshes/mesh_measures.h"
#include "meshes/smoothing_error.h"

#include <Eigen/Eigenvalues>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace pcl_normal_smoothing;

namespace
{
using Points = std::vector<Eigen::Vector3d>;

/** The unit cube with outward normals. */
tools::Mesh
makeCube ()
{
  tools::Mesh cube;
  for (int i = 0; i < 8; ++i)
    cube.vertices.emplace_back (i & 1, i >> 1 & 1, i >> 2);
  cube.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return cube;
}

/** Points of a bumpy surface, irregular enough that no two distances are equal. */
Points
makeBumps (double height)
{
  Points points;
  for (int i = 0; i < 200; ++i) {
    const double x = std::fmod (i * 0.754877666, 1), y = std::fmod (i * 0.569840291, 1);
    points.emplace_back (x, y, height * std::sin (37.0 * i));
  }
  return points;
}

/** The surface variation of point \a i, computed by brute force. */
double
variationAt (const Points& points, std::size_t i, std::size_t k)
{
  Points near = points;
  std::sort (near.begin (), near.end (), [&] (const auto& a, const auto& b) {
    return (a - points[i]).squaredNorm () < (b - points[i]).squaredNorm ();
  });
  near.resize (k);
  Eigen::Vector3d mean (0, 0, 0);
  for (const Eigen::Vector3d& p : near)
    mean += p / static_cast<double> (k);
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero ();
  for (const Eigen::Vector3d& p : near)
    covariance += (p - mean) * (p - mean).transpose ();
  const Eigen::Vector3d values = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> (covariance).eigenvalues ();
  return values[0] / values.sum ();
}
} // namespace

TEST (ErrorMeasures, DistancesToACube)
{
  const tools::Mesh cube = makeCube ();
  const std::vector<std::pair<Eigen::Vector3d, double>> known {
      {{0.5, 0.4, 1.3}, 0.3}, {{0.5, 0.4, 0.9}, 0.1}, {{1.3, 1.4, 0.5}, 0.5}, {{2, 3, 3}, 3}, {{0.2, 1, 0.7}, 0}};
  double sum = 0, squares = 0;
  Points points;
  for (const auto& [point, distance] : known) {
    EXPECT_NEAR (tools::distanceToMesh ({point}, cube).mean, distance, 1e-12) << point.transpose ();
    points.push_back (point);
    sum += distance;
    squares += distance * distance;
  }
  const tools::SurfaceDistance all = tools::distanceToMesh (points, cube);
  EXPECT_NEAR (all.mean, sum / 5, 1e-12);
  EXPECT_NEAR (all.rms, std::sqrt (squares / 5), 1e-12);
  EXPECT_NEAR (all.max, 3, 1e-12);
}

TEST (ErrorMeasures, AreaOfAScaledCube)
{
  const tools::Mesh cube = makeCube ();
  for (const double scale : {0.9, 1.1}) {
    Points points = cube.vertices;
    for (Eigen::Vector3d& p : points)
      p *= scale;
    EXPECT_NEAR (tools::areaError (points, cube), std::abs (scale * scale - 1), 1e-12);
  }
}

TEST (ErrorMeasures, SurfaceVariationAgainstASlowOracle)
{
  const Points clean = makeBumps (0.01), noisy = makeBumps (0.04);
  for (const unsigned k : {7u, 15u}) {
    double expected = 0;
    for (std::size_t i = 0; i < clean.size (); ++i)
      expected += std::abs (variationAt (noisy, i, k) - variationAt (clean, i, k)) / double (clean.size ());
    EXPECT_NEAR (tools::variationError (noisy, clean, k), expected, 1e-6) << k;
    EXPECT_GT (expected, 1e-3);
  }
}

TEST (ErrorMeasures, AnglesToTheNormalsOfACube)
{
  const tools::Mesh cube = makeCube ();
  const Points expected = tools::vertexNormals (cube);
  Points normals;
  for (const Eigen::Vector3d& n : expected)
    normals.push_back (normals.size () % 2 ? -n : n);
  EXPECT_NEAR (tools::meanAngle (normals, cube), 0, 1e-12); // signs do not matter
  for (std::size_t i = 0; i < 8; ++i)
    normals[i] = i < 4 ? expected[i].unitOrthogonal () : Eigen::Vector3d (0, 0, 0);
  EXPECT_NEAR (tools::meanAngle (normals, cube), 90, 1e-9); // only of the normals that are not zero
}
