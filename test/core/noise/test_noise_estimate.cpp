// SPDX-License-Identifier: BSD-3-Clause
#include "noise/scanned_room.h"
#include "shapes.h"

#include <core/noise/noise_sample.h>
#include <pcl_normal_smoothing/core/noise/noise_estimate.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace pcl_normal_smoothing::core;
using namespace test_support;

NoiseEstimate
estimateOf (const Vectors& points, std::uint32_t k = 16, unsigned threads = 2)
{
  const Execution execution (threads);
  const auto graph = NeighborGraph::build (asPositions (points), {k}, execution);
  return estimateNoise (*graph, gather (asPositions (points), graph->order ()), execution);
}

TEST (NoiseEstimateTest, ReadsTheNoiseOfKnownShapes)
{
  // The points of a Fibonacci sphere of radius 1 are sqrt (4 pi / n) apart; the other spacings are given.
  const double of_sphere = std::sqrt (4 * M_PI / 6000);
  for (const double noise : {0.05, 0.1, 0.2, 0.3, 0.5}) {
    const std::pair<Shape, double> shapes[] = {{sphere (6000, 1), of_sphere},
                                               {planeGrid (80, 0.01f), 0.01},
                                               {cube (40, 1), 1.0 / 40}};
    for (const auto& [shape, spacing] : shapes) {
      const double read = estimateOf (withNormalNoise (shape, noise * spacing, 3)).sigma;
      EXPECT_GT (read, 0.75 * noise * spacing) << noise;
      EXPECT_LT (read, 1.4 * noise * spacing) << noise;
    }
  }
}

TEST (NoiseEstimateTest, NoiseAlongRaysIsThatOfSurfacesThatFaceThem)
{
  for (const double noise : {0.005, 0.01, 0.03}) {
    const double read = estimateOf (ScannedRoom (60, 1, 1, noise).points).sigma;
    EXPECT_GT (read, 0.8 * noise) << noise;
    EXPECT_LT (read, 1.7 * noise) << noise;
  }
}

TEST (NoiseEstimateTest, WhereScanLinesMeetNoNoiseIsHidden)
{
  for (const double limit : {80., 85.}) // near the zenith most of the nearest lie on one line
    for (const double step : {.7, 1.})
      for (const double noise : {.005, .01, .02}) {
        const double read = estimateOf (ScannedRoom (limit, step, step, noise).points).sigma;
        EXPECT_GT (read, 0.8 * noise) << limit << " " << step << " " << noise;
        EXPECT_LT (read, 1.7 * noise) << limit << " " << step << " " << noise;
      }
}

TEST (NoiseEstimateTest, OutliersAreNoNoise)
{
  for (const std::size_t every : {50, 20}) {
    Vectors points = withNormalNoise (planeGrid (80, 0.01f), 0.001, 3);
    for (std::size_t i = 0; i < points.size (); i += every)
      points[i].z () += 0.05f * static_cast<float> (uniformNoise (5, i));
    EXPECT_LT (estimateOf (points).sigma, 0.0016) << every;
  }
}

TEST (NoiseEstimateTest, ShallowReliefIsNoNoise)
{
  for (const double noise : {0.01, 0.02, 0.05}) {
    const double read = estimateOf (withNormalNoise (groovedPlate (10), noise, 3)).sigma;
    EXPECT_GT (read, 0.75 * noise) << noise;
    EXPECT_LT (read, 2 * noise) << noise;
    EXPECT_LT (estimateOf (withNormalNoise (groovedPlate (9), noise, 3)).sigma, 4 * noise) << noise;
  }
}

TEST (NoiseEstimateTest, CopiesOfPointsAreNoNoise)
{
  const Vectors points = withNormalNoise (planeGrid (40, 0.01f), 0.002, 3);
  for (const std::size_t count : {4, 8}) { // copies of every tenth point
    Vectors copies = points;
    for (std::size_t i = 0; i < points.size (); i += 10)
      copies.insert (copies.end (), count, points[i]);
    const float read = estimateOf (copies).sigma;
    EXPECT_GE (read, 0);
    EXPECT_LT (read, 0.006) << count;
  }
}

TEST (NoiseEstimateTest, ReadsTheSpacing)
{
  EXPECT_NEAR (estimateOf (planeGrid (80, 0.01f).points).spacing, 0.01, 0.002);
}

TEST (NoiseEstimateTest, ACleanCloudHasNone)
{
  EXPECT_LT (estimateOf (planeGrid (80, 0.01f).points).sigma, 1e-6);
  EXPECT_LT (estimateOf (sphere (6000, 1).points).sigma, 0.02 * 0.045);
}

TEST (NoiseEstimateTest, OrderThreadsAndLargerRowsDoNotMatter)
{
  const Vectors points = withNormalNoise (torus (9000, 1, 0.4), 0.01, 3);
  const NoiseEstimate expected = estimateOf (points, 16, 1);
  for (const NoiseEstimate& other :
       {estimateOf (shuffled (points, 4)), estimateOf (points, 16, 4), estimateOf (points, 32)}) {
    EXPECT_EQ (other.sigma, expected.sigma);
    EXPECT_EQ (other.spacing, expected.spacing);
  }
}

TEST (NoiseEstimateTest, ShortRowsAreSearchedAgain)
{
  const Vectors points = withNormalNoise (sphere (6000, 1), 0.01, 3);
  EXPECT_EQ (estimateOf (points, 5).sigma, estimateOf (points, 16).sigma);
}

TEST (NoiseEstimateTest, WhereThereAreFewerPointsAllAreAsked)
{
  Vectors points = withNormalNoise (planeGrid (10, 0.01f), 0.001, 3);
  points.resize (12);
  const auto graph = NeighborGraph::build (asPositions (points), {32}, Execution (1));
  const NoiseSample sample = sampleNoise (*graph, gather (asPositions (points), graph->order ()), Execution (1));
  ASSERT_EQ (sample.of_nodes.size (), points.size ());
  for (const NoiseSample::Residuals& residuals : sample.of_nodes) {
    EXPECT_GT (residuals.variances[1], 0);
    EXPECT_EQ (residuals.variances[1], residuals.variances[2]);
  }
}

TEST (NoiseEstimateTest, TooFewPointsGiveZero)
{
  EXPECT_EQ (estimateOf (sphere (5, 1).points).sigma, 0);
  EXPECT_EQ (estimateOf (Vectors (50, Eigen::Vector3f (1, 2, 3))).sigma, 0);
}
} // namespace
