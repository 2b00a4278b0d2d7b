// SPDX-License-Identifier: BSD-3-Clause
#include "noise/scanned_room.h"
#include "preset_test.h"

#include <core/noise/neighborhood_widening.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace
{
using namespace pcl_normal_smoothing;
using namespace pcl_normal_smoothing::core;
using namespace test_support;

/** The points of a rotating lidar: four per degree in each line. */
Vectors
lidar (double noise, double degrees_between_lines = 2)
{
  return ScannedRoom (15, degrees_between_lines, .25, noise).points;
}

constexpr double ball_radius = 56;

double
ballHeight (double x, double y)
{
  return std::sqrt (ball_radius * ball_radius - x * x - y * y);
}

/** A wave with detail between the lines. */
double
waveHeight (double x, double y)
{
  return 4 * std::sin (x / 4) * std::cos (y / 4);
}

/** The points of a profiler above the surface. Its lines are five times as far apart as the points in them; each line
  * lies exactly in a plane. The spacing is 1, and the noise is along the rays. */
Vectors
profiles (double (*height) (double, double), double noise)
{
  constexpr double along = 0.447, across = 5 * along, rim = 0.9 * ball_radius;
  Vectors points;
  std::uint64_t number = 0;
  for (double x = -rim; x < rim; x += across)
    for (double y = -rim; y < rim; y += along)
      if (x * x + y * y < rim * rim) {
        const double z = height (x, y) + noise * gaussianNoise (12, number++);
        points.emplace_back (static_cast<float> (x), static_cast<float> (y), static_cast<float> (z));
      }
  return points;
}

double
meanDistanceToBall (const Vectors& points)
{
  double sum = 0;
  for (const auto& p : points)
    sum += std::abs (p.cast<double> ().norm () - ball_radius);
  return sum / static_cast<double> (points.size ());
}

RegionalField
linesOf (const Vectors& points, unsigned threads = 2)
{
  const Searched cloud (points);
  return estimateLines (*cloud.graph, cloud.nodes, Execution (threads)).halvings;
}

bool
haveLines (const Vectors& points)
{
  return !linesOf (points).regions.empty ();
}

/** Noise-free facets five spacings wide. */
Vectors
folded ()
{
  Vectors points = planeGrid (80, 0.01f).points;
  for (auto& p : points)
    p.z () = 0.5f * std::abs (std::remainder (p.x () - 0.005f, 0.1f));
  return points;
}

TEST (LinesTest, AreSeenWhateverTheNoise)
{
  for (const double noise : {0.0, 0.003, 0.01, 0.02, 0.04})
    EXPECT_TRUE (haveLines (lidar (noise))) << noise;
}

TEST (LinesTest, OtherCloudsHaveNone)
{
  for (const double sigma : {0.0, 0.002, 0.006}) {
    EXPECT_FALSE (haveLines (withNoise (planeGrid (80, 0.01f).points, sigma, 1))) << sigma;
    EXPECT_FALSE (haveLines (withNoise (cube (40, 0.4).points, sigma, 1))) << sigma;
    EXPECT_FALSE (haveLines (withNoise (torus (8000, 1, 0.4).points, 5 * sigma, 1))) << sigma;
    EXPECT_FALSE (haveLines (withNoise (cylinder (188, 60, 0.3, 0.6).points, sigma, 1))) << sigma;
  }
  EXPECT_FALSE (haveLines (ScannedRoom (60, 1, 1, 0.01).points));
  EXPECT_FALSE (haveLines (folded ()));
}

TEST (LinesTest, NeighbourhoodsGrowWithTheGap)
{
  float last = 0;
  for (const double gap : {1, 2, 4}) {
    const float halvings = linesOf (lidar (0.01, gap)).valueAt ({8, 0, 0}, -1);
    EXPECT_GT (halvings, last + 0.5f) << gap;
    last = halvings;
  }
}

TEST (LinesTest, ThreadsAndOrderDoNotMatter)
{
  const Vectors points = lidar (0.02);
  const std::vector<float> expected = linesOf (points, 1).values ();
  EXPECT_EQ (linesOf (points, 2).values (), expected);
  EXPECT_EQ (linesOf (shuffled (points, 4)).values (), expected);
  EXPECT_GT (expected.size (), 4u);
}

TEST (LinesTest, WideRowsHoldSeveralLinesAndAllPoints)
{
  const Searched cloud (lidar (0.01));
  const Widening widening = estimateWidening (*cloud.graph, cloud.nodes, Execution (2));
  EXPECT_FALSE (widening.layers.hasLayers ());
  const auto wide = widenNeighborhoods (*cloud.graph, cloud.nodes, widening, Execution (2));
  ASSERT_TRUE (wide);
  const auto lineOf = [&] (std::uint32_t node) {
    const Eigen::Vector3f& p = cloud.nodes.base[node];
    return std::lround (std::atan2 (p.z (), std::hypot (p.x (), p.y ())) * 90 / M_PI);
  };
  std::size_t single = 0;
  std::set<std::uint32_t> neighbors;
  for (std::uint32_t node = 0; node < wide->size (); ++node) {
    const Row row = wide->row (node);
    ASSERT_EQ (row.size (), 32u);
    ASSERT_EQ (row[0], node);
    std::set<long> lines;
    for (std::size_t j = 0; j < 8; ++j)
      lines.insert (lineOf (row[j]));
    single += lines.size () == 1;
    for (std::size_t j = 1; j < row.size (); ++j)
      neighbors.insert (row[j]);
  }
  EXPECT_LT (static_cast<double> (single), 0.2 * static_cast<double> (wide->size ()));
  EXPECT_GT (static_cast<double> (neighbors.size ()), 0.95 * static_cast<double> (wide->size ()));
}

TEST (LinesTest, TheNoiseIsThatAcrossTheLines)
{
  for (const double noise : {0.01, 0.02})
    for (const double gap : {1, 2, 4}) {
      const Searched cloud (lidar (noise, gap));
      const NoiseEstimate read = estimateNoise (*cloud.graph, cloud.nodes, Execution (2));
      EXPECT_GT (read.sigma, 0.7 * noise) << noise << ' ' << gap;
      EXPECT_LT (read.sigma, 2 * noise) << noise << ' ' << gap;
      EXPECT_LT (read.spacing, 0.1) << "of the cloud, not of the wide neighbourhoods";
    }
}

TEST (LinesTest, WithoutNoiseNothingMoves)
{
  const Vectors points = lidar (0);
  for (const Eigen::Vector3f& displacement : smoothed (asPositions (points), 32, wideningOptions (false)).displacements)
    ASSERT_LT (displacement.norm (), 0.002);
}

TEST (LinesTest, WhatIsBetweenTheLinesOfAProfilerIsNoNoise)
{
  for (const auto height : {ballHeight, waveHeight})
    for (const double noise : {0.02, 0.1}) {
      const Searched cloud (profiles (height, noise));
      const NoiseEstimate read = estimateNoise (*cloud.graph, cloud.nodes, Execution (2));
      EXPECT_GT (read.sigma, 0.5 * noise) << noise;
      EXPECT_LT (read.sigma, 1.5 * noise) << noise;
    }
}

TEST (LinesTest, PointsOnRaysAreNoLinesOfAProfiler)
{
  Vectors points;
  for (int frame = 0; frame < 12; ++frame)
    for (double x = -0.5; x < 0.5; x += 0.02)
      for (double y = -0.5; y < 0.5; y += 0.02) {
        const double range = 2 + 0.05 * gaussianNoise (13 + static_cast<std::uint64_t> (frame), points.size ());
        points.push_back ((range * Eigen::Vector3d (x, y, 1)).cast<float> ());
      }
  const Searched cloud (points);
  const LineEstimate lines = estimateLines (*cloud.graph, cloud.nodes, Execution (2));
  EXPECT_TRUE (lines.hasLines ()) << "the test is of no use";
  EXPECT_TRUE (std::isinf (lines.most_sigma));
}

TEST (LinesTest, BehindTheGapsMayBeOtherSheets)
{
  for (const bool are_lines : {false, true}) {
    const Searched cloud (are_lines ? lidar (0.01) : ScannedRoom (60, 1, 1, 0.01).points);
    const SmoothingOptions fast = prepared (wideningOptions (true), cloud);
    EXPECT_EQ (std::isfinite (fast.rounds.sheet_distance), are_lines);
  }
}

class LinesPresets : public PresetTest
{};

TEST_P (LinesPresets, LinesAreSmoothedAcross)
{
  for (const double noise : {0.01, 0.02, 0.08}) {
    const Vectors points = lidar (noise);
    SmoothingOptions options = wideningOptions (isFast ());
    const double before = ScannedRoom::error (points);
    const Vectors widened = sum (points, smoothed (asPositions (points), k (), options).displacements);
    EXPECT_LT (ScannedRoom::error (widened), 0.6 * before) << noise;
    options.widen_neighborhoods = false;
    const Vectors stuck = sum (points, smoothed (asPositions (points), k (), options).displacements);
    EXPECT_GT (ScannedRoom::error (stuck), 0.9 * before) << noise << ": the test is of no use";
  }
}

TEST_P (LinesPresets, ProfilesOfABallAreSmoothed)
{
  for (const double noise : {0.0, 0.02, 0.1}) {
    const Vectors points = profiles (ballHeight, noise);
    const Vectors moved =
        sum (points, smoothed (asPositions (points), k (), wideningOptions (isFast ())).displacements);
    EXPECT_LE (meanDistanceToBall (moved), std::max (0.4 * meanDistanceToBall (points), 1e-4)) << noise;
  }
}

INSTANTIATE_TEST_SUITE_P (Presets, LinesPresets, testing::Bool (), nameOfPreset);

TEST (LinesTest, HideTheNoise)
{
  EXPECT_EQ (noiseHiddenBy (lidar (0.01)), NoiseHiddenBy::LINES);
  EXPECT_EQ (noiseHiddenBy (ScannedRoom (60, 1, 1, 0.01).points), NoiseHiddenBy::NOTHING);
}
} // namespace
