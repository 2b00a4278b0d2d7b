// SPDX-License-Identifier: BSD-3-Clause
#include "searched.h"
#include "smoothed.h"

#include <pcl_normal_smoothing/core/neighborhood_widening.h>
#include <pcl_normal_smoothing/core/smoothing_preparation.h>

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

/** A square in sweeps that cross: along each, points are closer to each other than to those of another. */
Vectors
crossingSweeps (double noise)
{
  constexpr std::uint64_t sweeps = 160, points_of_each = 300;
  Vectors points;
  for (std::uint64_t i = 0; i < sweeps * points_of_each; ++i) {
    const std::uint64_t sweep = i / points_of_each;
    const double direction = 2 * M_PI * uniformNoise (4, sweep);
    const double way = static_cast<double> (i % points_of_each) / points_of_each - .5;
    const Eigen::Vector3d point (uniformNoise (5, sweep) + way * std::cos (direction),
                                 uniformNoise (6, sweep) + way * std::sin (direction), noise * gaussianNoise (7, i));
    if (point.head<2> ().minCoeff () > 0 && point.head<2> ().maxCoeff () < 1)
      points.push_back (point.cast<float> ());
  }
  return points;
}

/** From the plane z = 0. */
double
meanDistance (const Vectors& points)
{
  double sum = 0;
  for (const auto& p : points)
    sum += std::abs (p.z ());
  return sum / static_cast<double> (points.size ());
}

WideNoise
wideNoiseOf (const Vectors& points, unsigned threads = 2)
{
  const Searched cloud (points);
  return estimateWideNoise (*cloud.graph, cloud.nodes, Execution (threads));
}

RegionalField
halvingsOf (const Vectors& points, unsigned threads = 2)
{
  return wideNoiseOf (points, threads).halvings;
}

TEST (WideNoiseTest, NeighbourhoodsGrowWithTheNoise)
{
  float last = 0;
  for (const double noise : {0.5, 0.75, 1.1}) {
    const float halvings = halvingsOf (square (noise)).valueAt ({.5f, .5f, 0}, -1);
    EXPECT_GT (halvings, last + 0.5f) << noise;
    last = halvings;
  }
}

TEST (WideNoiseTest, WhereTheyWouldLoseDetailPointsAreProjected)
{
  const auto waves = [] (double length) {
    Vectors points = square (1);
    for (Eigen::Vector3f& point : points)
      point.z () += static_cast<float> (0.1 * length * std::sin (2 * M_PI * point.x () / length));
    return points;
  };
  const WideNoise of_detail = wideNoiseOf (waves (0.15)), of_long_waves = wideNoiseOf (waves (5));
  EXPECT_TRUE (of_detail.halvings.regions.empty ());
  EXPECT_NEAR (of_detail.ratios.valueAt ({.5f, .5f, 0}, 0), 1, 0.3f);
  EXPECT_TRUE (of_long_waves.ratios.regions.empty ()) << "as wide as the square: no detail";
  EXPECT_GT (of_long_waves.halvings.valueAt ({.5f, .5f, 0}, -1),
             halvingsOf (square (1)).valueAt ({.5f, .5f, 0}, -1) - 0.5f);
}

TEST (WideNoiseTest, OtherCloudsAreAsTheyAre)
{
  EXPECT_TRUE (halvingsOf (square (0)).regions.empty ());
  EXPECT_TRUE (halvingsOf (square (0.2)).regions.empty ());
  for (const double noise : {0.1, 0.3})
    EXPECT_TRUE (halvingsOf (withNoise (sphere (8000, 1).points, noise * 0.04, 1)).regions.empty ()) << noise;
}

TEST (WideNoiseTest, ClumpsHideIt)
{
  EXPECT_GT (halvingsOf (crossingSweeps (0.006)).valueAt ({.5f, .5f, 0}, -1), 1.5f);
  EXPECT_GT (halvingsOf (crossingSweeps (0.003)).valueAt ({.5f, .5f, 0}, -1), 0.5f);
}

TEST (WideNoiseTest, CloseSheetsAreNone)
{
  for (const float gap : {0.009f, 0.01f, 0.012f})
    EXPECT_EQ (wideNoiseOf (withNoise (parallelSheets (80, 0.01f, gap).points, 0.001, 1)).sigma, 0) << gap;
  for (const double noise : {0.3, 0.4, 0.5})
    EXPECT_EQ (wideNoiseOf (withNoise (parallelSheets (80, 0.01f, 0.02f).points, noise * 0.01, 1)).sigma, 0) << noise;
}

TEST (WideNoiseTest, WhatIsNoSurfaceStays)
{
  Vectors leaves;
  for (std::uint64_t i = 0; i < count; ++i)
    leaves.push_back (Eigen::Vector3d (uniformNoise (1, i), uniformNoise (2, i), uniformNoise (3, i)).cast<float> ());
  EXPECT_TRUE (halvingsOf (leaves).regions.empty ());
}

TEST (WideNoiseTest, ThreadsAndOrderDoNotMatter)
{
  const Vectors points = square (1);
  Vectors shuffled;
  for (const std::uint32_t i : permutation (points.size (), 4))
    shuffled.push_back (points[i]);
  const std::vector<float> expected = halvingsOf (points, 1).values ();
  EXPECT_FALSE (expected.empty ());
  EXPECT_EQ (halvingsOf (points, 2).values (), expected);
  EXPECT_EQ (halvingsOf (shuffled).values (), expected);
}

/** Of a bumpy sphere, from its middle. */
double
heightOfBumps (const Eigen::Vector3d& direction)
{
  return 1 + 0.05 * std::sin (8 * direction.x ()) * std::sin (8 * direction.y ()) * std::sin (8 * direction.z ());
}

/** At random points, with noise in all directions, in spacings; with bumps. */
Vectors
bumpySphere (double noise)
{
  const double spacing_of_sphere = std::sqrt (4 * M_PI / count);
  Vectors points;
  for (std::uint64_t i = 0; i < count; ++i) {
    const double z = 2 * uniformNoise (1, i) - 1, angle = 2 * M_PI * uniformNoise (2, i),
                 in_plane = std::sqrt (1 - z * z);
    const Eigen::Vector3d direction (in_plane * std::cos (angle), in_plane * std::sin (angle), z);
    points.push_back ((heightOfBumps (direction) * direction).cast<float> ());
  }
  return withNoise (points, noise * spacing_of_sphere, 3);
}

TEST (WideNoiseTest, AllOfTheNoiseIsRead)
{
  for (const double noise : {0.5, 1.0, 2.0}) {
    const Searched cloud (square (noise));
    const NoiseEstimate read = estimateNoise (*cloud.graph, cloud.nodes, Execution (2));
    EXPECT_NEAR (read.sigma / (noise * spacing), 1, 0.2) << noise;
    EXPECT_LT (read.spacing, 3 * spacing) << "of the cloud, not of the wide neighbourhoods";
  }
  const Searched bumps (bumpySphere (1.5)); // whose points are projected
  const NoiseEstimate read = estimateNoise (*bumps.graph, bumps.nodes, Execution (2));
  EXPECT_NEAR (read.sigma / (1.5 * std::sqrt (4 * M_PI) * spacing), 1, 0.2);
}

/** What the smoothing takes for sigma, over what is read. */
float
takenOverRead (const Vectors& points)
{
  Searched cloud (points);
  NeighborGraph::ConstPtr graph = cloud.graph;
  SmoothingOptions options = wideningOptions (false);
  prepareSmoothing ({}, Execution (2), graph, options, cloud.nodes);
  return options.rounds.noise.sigma / estimateNoise (*cloud.graph, cloud.nodes, Execution (2)).sigma;
}

TEST (WideNoiseTest, SmoothingTakesItToBeLargerThanItIsRead)
{
  EXPECT_NEAR (takenOverRead (square (0.2)), 1, 0.01);
  EXPECT_NEAR (takenOverRead (square (1)), 1.5, 0.01);
}

TEST (WideNoiseTest, SoItDoesOfEvenPointsWhereItIsReadInPart)
{
  const auto noisySphere = [] (double noise) { // along the normals
    Vectors points = sphere (8000, 1).points;
    for (std::size_t i = 0; i < points.size (); ++i)
      points[i] *= static_cast<float> (1 + noise * 0.04 * gaussianNoise (1, i));
    return points;
  };
  EXPECT_NEAR (takenOverRead (noisySphere (0.3)), 1, 0.01);
  EXPECT_NEAR (takenOverRead (noisySphere (0.8)), 1.6, 0.01);
}

class WideNoisePresets : public testing::TestWithParam<bool>
{
protected:
  static double
  shareLeft (const Vectors& points, std::uint32_t k, const SmoothingOptions& options)
  {
    return meanDistance (sum (points, smoothed (asPositions (points), k, options).displacements)) /
           meanDistance (points);
  }
};

TEST_P (WideNoisePresets, ItIsSmoothed)
{
  for (const double noise : {0.5, 1.0}) {
    const Vectors points = square (noise);
    SmoothingOptions options = wideningOptions (GetParam ());
    const std::uint32_t k = GetParam () ? 16 : 32;
    EXPECT_LT (shareLeft (points, k, options), 0.3) << noise;
    options.widen_neighborhoods = false;
    EXPECT_GT (shareLeft (points, k, options), 0.4) << noise << ": the test is of no use";
  }
}

TEST_P (WideNoisePresets, DetailIsKept)
{
  const auto meanOffset = [] (const Vectors& points) {
    double sum = 0;
    for (const Eigen::Vector3f& point : points)
      sum += std::abs (point.cast<double> ().norm () - heightOfBumps (point.cast<double> ().normalized ()));
    return sum / static_cast<double> (points.size ());
  };
  const SmoothingOptions options = wideningOptions (GetParam ());
  for (const double noise : {0.5, 1.0, 2.0}) {
    const Vectors points = bumpySphere (noise);
    const Vectors moved = sum (points, smoothed (asPositions (points), GetParam () ? 16 : 32, options).displacements);
    EXPECT_LT (meanOffset (moved), (GetParam () ? 0.4 : 0.3) * meanOffset (points)) << noise;
  }
}

TEST_P (WideNoisePresets, ThinPlatesKeepTheirThickness)
{
  for (const double noise : {0.3, 0.4, 0.5}) {
    const Vectors sheets = parallelSheets (80, 0.01f, 0.02f).points;
    const Vectors noisy = withNoise (sheets, noise * 0.01, 1);
    const auto meanOffset = [&] (const Vectors& points) {
      double sum = 0;
      for (std::size_t i = 0; i < points.size (); ++i)
        sum += std::abs (points[i].z () - sheets[i].z ());
      return sum / static_cast<double> (points.size ());
    };
    const std::uint32_t k = GetParam () ? 16 : 32;
    const Vectors moved = sum (noisy, smoothed (asPositions (noisy), k, wideningOptions (GetParam ())).displacements);
    EXPECT_LT (meanOffset (moved), meanOffset (noisy)) << noise;
  }
}

TEST_P (WideNoisePresets, NoPointGoesFartherThanItMay)
{
  const Vectors points = bumpySphere (1.5);
  SmoothingOptions options = wideningOptions (GetParam ());
  ASSERT_FALSE (wideNoiseOf (points).ratios.regions.empty ()) << "the test is of no use";
  options.rounds.max_displacement = 0.02f;
  float farthest = 0;
  for (const Eigen::Vector3f& way : smoothed (asPositions (points), GetParam () ? 16 : 32, options).displacements)
    farthest = std::max (farthest, way.norm ());
  EXPECT_NEAR (farthest, 0.02f, 1e-6f);
}

TEST_P (WideNoisePresets, WithoutRoundsOrNoiseNothingMoves)
{
  const Vectors points = bumpySphere (1.5);
  SmoothingOptions without_rounds = wideningOptions (GetParam ()), without_noise = without_rounds;
  without_rounds.rounds.rounds = 0;
  without_noise.rounds.noise.sigma = 0;
  for (const SmoothingOptions& options : {without_rounds, without_noise})
    for (const Eigen::Vector3f& way : smoothed (asPositions (points), GetParam () ? 16 : 32, options).displacements)
      ASSERT_EQ (way, Eigen::Vector3f::Zero ());
}

TEST_P (WideNoisePresets, ItIsSmoothedWhereItHidesInClumps)
{
  const Vectors points = crossingSweeps (0.004);
  SmoothingOptions options = wideningOptions (GetParam ());
  const std::uint32_t k = GetParam () ? 16 : 32;
  EXPECT_LT (shareLeft (points, k, options), 0.15);
  options.widen_neighborhoods = false;
  EXPECT_GT (shareLeft (points, k, options), 0.8) << "the test is of no use";
}

INSTANTIATE_TEST_SUITE_P (Presets, WideNoisePresets, testing::Bool (), [] (const auto& preset) {
  return preset.param ? "Fast" : "Default";
});
} // namespace
