// SPDX-License-Identifier: BSD-3-Clause
#include "searched.h"
#include "smoothed.h"

#include <pcl_normal_smoothing/core/neighborhood_widening.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace pcl_normal_smoothing;
using namespace pcl_normal_smoothing::core;
using namespace test_support;

constexpr int count = 20000;
const double spacing = 1 / std::sqrt (count);

/** A square at random points; noise in spacings. */
Vectors
square (double noise)
{
  Vectors points;
  for (std::uint64_t i = 0; i < count; ++i)
    points.push_back (Eigen::Vector3d (uniformNoise (1, i), uniformNoise (2, i), noise * spacing * gaussianNoise (3, i))
                          .cast<float> ());
  return points;
}

RegionalField
wideNoiseOf (const Vectors& points, unsigned threads = 2)
{
  const Searched cloud (points);
  return estimateWideNoise (*cloud.graph, cloud.nodes, Execution (threads));
}

TEST (WideNoiseTest, NeighbourhoodsGrowWithTheNoise)
{
  float last = 0;
  for (const double noise : {0.5, 1.0, 2.0}) {
    const float halvings = wideNoiseOf (square (noise)).valueAt ({.5f, .5f, 0}, -1);
    EXPECT_GT (halvings, last + 0.5f) << noise;
    last = halvings;
  }
}

TEST (WideNoiseTest, OtherCloudsAreAsTheyAre)
{
  EXPECT_TRUE (wideNoiseOf (square (0)).regions.empty ());
  EXPECT_TRUE (wideNoiseOf (square (0.2)).regions.empty ());
  for (const double noise : {0.1, 0.3})
    EXPECT_TRUE (wideNoiseOf (withNoise (sphere (8000, 1).points, noise * 0.04, 1)).regions.empty ()) << noise;
}

TEST (WideNoiseTest, CloseSheetsAreNone)
{
  for (const float gap : {0.009f, 0.01f, 0.012f})
    EXPECT_TRUE (wideNoiseOf (withNoise (parallelSheets (80, 0.01f, gap).points, 0.001, 1)).regions.empty ()) << gap;
}

TEST (WideNoiseTest, WhatIsNoSurfaceStays)
{
  Vectors leaves;
  for (std::uint64_t i = 0; i < count; ++i)
    leaves.push_back (Eigen::Vector3d (uniformNoise (1, i), uniformNoise (2, i), uniformNoise (3, i)).cast<float> ());
  EXPECT_TRUE (wideNoiseOf (leaves).regions.empty ());
}

TEST (WideNoiseTest, ThreadsAndOrderDoNotMatter)
{
  const Vectors points = square (1);
  Vectors shuffled;
  for (const std::uint32_t i : permutation (points.size (), 4))
    shuffled.push_back (points[i]);
  const std::vector<float> expected = wideNoiseOf (points, 1).values ();
  EXPECT_FALSE (expected.empty ());
  EXPECT_EQ (wideNoiseOf (points, 2).values (), expected);
  EXPECT_EQ (wideNoiseOf (shuffled).values (), expected);
}

TEST (WideNoiseTest, AllOfTheNoiseIsRead)
{
  for (const double noise : {0.5, 1.0, 2.0}) {
    const Searched cloud (square (noise));
    const NoiseEstimate read = estimateNoise (*cloud.graph, cloud.nodes, Execution (2));
    EXPECT_NEAR (read.sigma / (noise * spacing), 1, 0.2) << noise;
    EXPECT_LT (read.spacing, 3 * spacing) << "of the cloud, not of the wide neighbourhoods";
  }
}

class WideNoisePresets : public testing::TestWithParam<bool>
{};

TEST_P (WideNoisePresets, ItIsSmoothed)
{
  const auto error = [] (const Vectors& points) {
    double sum = 0;
    for (const auto& p : points)
      sum += std::abs (p.z ());
    return sum / count;
  };
  for (const double noise : {0.5, 1.0}) {
    const Vectors points = square (noise);
    SmoothingOptions options = wideningOptions (GetParam ());
    const std::uint32_t k = GetParam () ? 16 : 32;
    EXPECT_LT (error (sum (points, smoothed (asPositions (points), k, options).displacements)), 0.3 * error (points))
        << noise;
    options.widen_neighborhoods = false;
    EXPECT_GT (error (sum (points, smoothed (asPositions (points), k, options).displacements)), 0.4 * error (points))
        << noise << ": the test is of no use";
  }
}

INSTANTIATE_TEST_SUITE_P (Presets, WideNoisePresets, testing::Bool (), [] (const auto& preset) {
  return preset.param ? "Fast" : "Default";
});
} // namespace
