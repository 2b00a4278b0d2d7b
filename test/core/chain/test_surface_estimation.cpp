// SPDX-License-Identifier: BSD-3-Clause
#include "graph_rows.h"
#include "oracle.h"

#include <pcl_normal_smoothing/core/chain/surface_estimation.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
using namespace pcl_normal_smoothing::core;
using namespace test_support;
using pcl_normal_smoothing::NormalSource;

constexpr float no_radius = std::numeric_limits<float>::infinity ();

std::vector<LocalSurface>
surfacesByPoint (const Positions& cloud, NormalSource source, std::uint32_t k)
{
  const auto graph = NeighborGraph::build (cloud, {k, no_radius}, Execution (2));
  const auto of_nodes =
      estimateSurfaces (*graph, gather (cloud, graph->order ()), makeEstimator (source, {}), Execution (2));
  std::vector<LocalSurface> of_points (cloud.size (), {Eigen::Vector3f (7, 7, 7), 7});
  for (std::size_t node = 0; node < of_nodes.size (); ++node)
    of_points[graph->order ()[node]] = of_nodes[node];
  return of_points;
}

class EigenSurfaceTest : public testing::TestWithParam<std::tuple<NormalSource, std::uint32_t>>
{};

TEST_P (EigenSurfaceTest, AgreesWithTheOracle)
{
  const auto [source, k] = GetParam ();
  const Vectors cloud = withNoise (torus (1500, 1, 0.4).points, 0.02, 30);
  const Points points = inDouble (cloud);
  const Rows rows = nearestRows (points, k);
  const auto surfaces = surfacesByPoint (asPositions (cloud), source, k);
  for (std::size_t i = 0; i < points.size (); ++i) {
    const OracleSurface expected =
        source == NormalSource::PCA ? oraclePca (points, rows[i]) : oracleWpca (points, i, rows[i]);
    EXPECT_LT (lineAngleDegrees (surfaces[i].normal.cast<double> (), expected.normal), 0.05) << "point " << i;
    EXPECT_NEAR (surfaces[i].variation, expected.variation, 1e-6) << "point " << i;
    EXPECT_NEAR (surfaces[i].normal.norm (), 1, 1e-6) << "point " << i;
  }
}

TEST_P (EigenSurfaceTest, APlaneHasItsNormalAndNoVariation)
{
  const auto [source, k] = GetParam ();
  for (const LocalSurface& surface : surfacesByPoint (asPositions (planeGrid (20, 0.1f).points), source, k)) {
    EXPECT_LT (lineAngleDegrees (surface.normal.cast<double> (), Eigen::Vector3d::UnitZ ()), 1e-3);
    EXPECT_NEAR (surface.variation, 0, 1e-9);
  }
}

TEST_P (EigenSurfaceTest, ASphereAndACylinderHaveTheirNormals)
{
  const auto [source, k] = GetParam ();
  for (const Shape& shape : {sphere (3000, 2), cylinder (60, 40, 1, 4)}) {
    const auto surfaces = surfacesByPoint (asPositions (shape.points), source, k);
    double sum = 0;
    for (std::size_t i = 0; i < shape.size (); ++i)
      sum += lineAngleDegrees (surfaces[i].normal.cast<double> (), shape.normals[i].cast<double> ());
    EXPECT_LT (sum / static_cast<double> (shape.size ()), 1.5);
  }
}

TEST_P (EigenSurfaceTest, DuplicatesDoNotHarm)
{
  const auto [source, k] = GetParam ();
  Vectors twice = planeGrid (12, 1).points;
  twice.insert (twice.end (), twice.begin (), twice.begin () + 144);
  for (const LocalSurface& surface : surfacesByPoint (asPositions (twice), source, k))
    EXPECT_LT (lineAngleDegrees (surface.normal.cast<double> (), Eigen::Vector3d::UnitZ ()), 1e-3);
}

INSTANTIATE_TEST_SUITE_P (Sources,
                          EigenSurfaceTest,
                          testing::Combine (testing::Values (NormalSource::PCA, NormalSource::WPCA),
                                            testing::Values (7u, 15u)),
                          [] (const auto& test) {
                            const bool pca = std::get<0> (test.param) == NormalSource::PCA;
                            return (pca ? "PCA" : "WPCA") + std::to_string (std::get<1> (test.param));
                          });

class AnySurfaceTest : public testing::TestWithParam<NormalSource>
{};

TEST_P (AnySurfaceTest, WithoutAPlaneThereIsNoNormal)
{
  Vectors line, equal (20, Eigen::Vector3f (1, 2, 3)), two {{0, 0, 0}, {1, 0, 0}};
  for (int i = 0; i < 20; ++i)
    line.push_back (static_cast<float> (i) * Eigen::Vector3f (1, 0, 0));
  for (const Vectors& cloud : {line, equal, two})
    for (const LocalSurface& surface : surfacesByPoint (asPositions (cloud), GetParam (), 7)) {
      EXPECT_TRUE (std::isnan (surface.normal.x ())) << surface.normal.transpose ();
      EXPECT_TRUE (std::isnan (surface.variation));
    }
}

TEST_P (AnySurfaceTest, ATriangleHasItsNormal)
{
  const Vectors triangle {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const LocalSurface& surface : surfacesByPoint (asPositions (triangle), GetParam (), 3)) {
    // WPCA leaves out the point itself, so it sees only two points, a line.
    if (GetParam () == NormalSource::WPCA)
      EXPECT_TRUE (std::isnan (surface.variation));
    else
      EXPECT_LT (lineAngleDegrees (surface.normal.cast<double> (), Eigen::Vector3d::Ones ()), 1e-3);
  }
}

TEST_P (AnySurfaceTest, QueriesOnASurfaceGiveWhatTheGraphGives)
{
  const Positions cloud = asPositions (withNoise (torus (600, 1, 0.4).points, 0.02, 31));
  const auto of_graph = surfacesByPoint (cloud, GetParam (), 9);
  const auto of_queries = querySurfaces (cloud, cloud, {9, no_radius}, makeEstimator (GetParam (), {}), Execution (2));
  const auto of_search = querySurfaces (
      cloud, cloud,
      [&] (std::size_t i, auto& found) {
        found = bruteForceRow (cloud, std::uint32_t (i), {9, no_radius});
      },
      makeEstimator (GetParam (), {}), Execution (2));
  for (std::size_t i = 0; i < cloud.size (); ++i) {
    EXPECT_EQ (of_queries[i].normal, of_graph[i].normal) << "point " << i;
    EXPECT_EQ (of_search[i].normal, of_graph[i].normal) << "point " << i;
    EXPECT_EQ (of_queries[i].variation, of_graph[i].variation) << "point " << i;
  }
}

INSTANTIATE_TEST_SUITE_P (Sources,
                          AnySurfaceTest,
                          testing::Values (NormalSource::PCA, NormalSource::WPCA, NormalSource::HOUGH));
} // namespace
