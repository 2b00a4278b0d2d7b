// SPDX-License-Identifier: BSD-3-Clause
#include "graph_rows.h"
#include "oracle.h"

#include <pcl_normal_smoothing/core/chain/surface_estimation.h>
#include <pcl_normal_smoothing/core/error.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
using namespace pcl_normal_smoothing::core;
using namespace test_support;
using pcl_normal_smoothing::NormalSource;

Vectors
normalsByPoint (const Vectors& cloud, std::uint32_t k, NormalSource source, const HoughOptions& options = {})
{
  const Positions positions = asPositions (cloud);
  const auto graph = NeighborGraph::build (positions, {k}, Execution (2));
  const Vectors of_nodes =
      estimateNormals (*graph, gather (positions, graph->order ()), makeEstimator (source, options), Execution (2));
  return byPoint (of_nodes, *graph);
}

double
meanAngle (const Vectors& normals, const Vectors& expected)
{
  double sum = 0;
  for (std::size_t i = 0; i < normals.size (); ++i)
    sum += lineAngleDegrees (normals[i].cast<double> (), expected[i].cast<double> ());
  return sum / static_cast<double> (normals.size ());
}

TEST (Hough, IsTheSameForTheSameSeedAndAnotherForAnother)
{
  const Vectors cloud = withNoise (cube (12, 1).points, 0.01, 40);
  HoughOptions options;
  const Vectors first = normalsByPoint (cloud, 20, NormalSource::HOUGH, options);
  EXPECT_EQ (normalsByPoint (cloud, 20, NormalSource::HOUGH, options), first);
  options.seed = 1;
  const Vectors other = normalsByPoint (cloud, 20, NormalSource::HOUGH, options);
  EXPECT_NE (other, first);
  EXPECT_LT (meanAngle (other, first), 5);
}

TEST (Hough, DoesNotDependOnTheOrderOfThePoints)
{
  const Vectors cloud = withNoise (cube (12, 1).points, 0.01, 41);
  const auto order = permutation (cloud.size (), 42);
  const Vectors normals = normalsByPoint (cloud, 20, NormalSource::HOUGH);
  const Vectors of_shuffled = normalsByPoint (shuffled (cloud, 42), 20, NormalSource::HOUGH);
  for (std::size_t i = 0; i < order.size (); ++i)
    EXPECT_EQ (of_shuffled[i], normals[order[i]]) << "point " << order[i];
}

TEST (Hough, IsCloseToTruthBesideAnEdgeWherePcaIsNot)
{
  const Shape shape = cube (30, 1);
  Vectors hough, pca, truth;
  const Vectors all_hough = normalsByPoint (shape.points, 20, NormalSource::HOUGH);
  const Vectors all_pca = normalsByPoint (shape.points, 20, NormalSource::PCA);
  for (std::size_t i = 0; i < shape.size (); ++i) {
    Eigen::Array3f to_face = shape.points[i].array ().min (1 - shape.points[i].array ());
    std::sort (to_face.data (), to_face.data () + 3);
    if (to_face[1] > 0.04 || to_face[2] < 0.2) // at most one step from an edge, and away from the corners
      continue;
    hough.push_back (all_hough[i]);
    pca.push_back (all_pca[i]);
    truth.push_back (shape.normals[i]);
  }
  ASSERT_GT (truth.size (), 200u);
  EXPECT_LT (meanAngle (hough, truth), 6);
  EXPECT_GT (meanAngle (pca, truth), 20);
}

TEST (Hough, IsAsGoodAsAllTriplesInManyAccumulators)
{
  const Shape shape = torus (1200, 1, 0.4);
  const Vectors cloud = withNoise (shape.points, 0.01, 43);
  const Points points = inDouble (cloud);
  for (const std::uint32_t k : {7u, 15u}) {
    const Rows rows = nearestRows (points, k);
    Vectors oracle, truth, of_hundred;
    const Vectors all = normalsByPoint (cloud, k, NormalSource::HOUGH);
    for (std::size_t i = 0; i < 100; ++i) {
      oracle.push_back (oracleHough (points, rows[i], 15).cast<float> ());
      truth.push_back (shape.normals[i]);
      of_hundred.push_back (all[i]);
    }
    const double angle = meanAngle (of_hundred, truth), of_oracle = meanAngle (oracle, truth);
    EXPECT_LT (angle, 1.2 * of_oracle) << "k " << k;
    EXPECT_GT (angle, 0.6 * of_oracle) << "k " << k << ": better than the method can be";
    EXPECT_LT (meanAngle (of_hundred, oracle), 0.7 * of_oracle) << "k " << k;
  }
}

TEST (Hough, KnowsAPlaneExactly)
{
  for (const auto& normal : normalsByPoint (planeGrid (15, 0.1f).points, 15, NormalSource::HOUGH))
    EXPECT_LT (lineAngleDegrees (normal.cast<double> (), Eigen::Vector3d::UnitZ ()), 1e-3);
}

TEST (Hough, KnowsAPlaneInAnyUnit)
{
  for (const float unit : {0x1p-45f, 0x1p45f}) { // fourth powers of lengths exceed the range of float
    Vectors cloud = planeGrid (15, 0.1f).points;
    for (auto& point : cloud)
      point *= unit;
    for (const auto& normal : normalsByPoint (cloud, 15, NormalSource::HOUGH))
      EXPECT_LT (lineAngleDegrees (normal.cast<double> (), Eigen::Vector3d::UnitZ ()), 1e-3);
  }
}

TEST (Hough, DrawsTheTriplesOfItsBound)
{
  const HoughEstimator estimator ({});
  EXPECT_NEAR (static_cast<double> (estimator.binCount ()), 155, 15); // 2 n_phi sin (angle) per band, about 144 in all
  const double bound = std::log (2 * static_cast<double> (estimator.binCount ()) / 0.05) / (2 * 0.08 * 0.08);
  EXPECT_NEAR (static_cast<double> (estimator.maxTriples ()), bound, 1.5);
}

TEST (Hough, RefusesParametersOutOfRange)
{
  const auto refused = [] (auto set) {
    HoughOptions options;
    set (options);
    EXPECT_THROW (HoughEstimator {options}, Error);
  };
  const float nan = std::numeric_limits<float>::quiet_NaN ();
  for (const float share : {0.0f, 1.0f, -0.5f, 2.0f, nan}) {
    refused ([=] (HoughOptions& options) { options.confidence = share; });
    refused ([=] (HoughOptions& options) { options.tolerance = share; });
  }
  refused ([] (HoughOptions& options) { options.tolerance = 0.0009f; });
  for (const int number : {-1, 0, 1001}) {
    refused ([=] (HoughOptions& options) { options.bands = number; });
    refused ([=] (HoughOptions& options) { options.rotations = number; });
  }
}
} // namespace
