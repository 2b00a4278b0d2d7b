// SPDX-License-Identifier: BSD-3-Clause
#include "noise/wide_clouds.h"
#include "preset_test.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
using namespace pcl_normal_smoothing;
using namespace pcl_normal_smoothing::core;
using namespace test_support;

class WideNoisePresets : public PresetTest
{
protected:
  static double
  shareLeft (const Vectors& points, const SmoothingOptions& options)
  {
    return meanDistance (sum (points, smoothed (asPositions (points), k (), options).displacements)) /
           meanDistance (points);
  }
};

TEST_P (WideNoisePresets, ItIsSmoothed)
{
  for (const double noise : {0.5, 1.0}) {
    const Vectors points = square (noise);
    SmoothingOptions options = wideningOptions (isFast ());
    EXPECT_LT (shareLeft (points, options), 0.3) << noise;
    options.widen_neighborhoods = false;
    EXPECT_GT (shareLeft (points, options), 0.4) << noise << ": the test is of no use";
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
  const SmoothingOptions options = wideningOptions (isFast ());
  for (const double noise : {0.5, 1.0, 2.0}) {
    const Vectors points = bumpySphere (noise);
    const Vectors moved = sum (points, smoothed (asPositions (points), k (), options).displacements);
    EXPECT_LT (meanOffset (moved), (isFast () ? 0.4 : 0.3) * meanOffset (points)) << noise;
  }
}

TEST_P (WideNoisePresets, WallsFarFromADepthCameraAreSmoothed)
{
  const Vectors walls = twoWalls (1, 5), noisy = withNoiseOfDepth (walls, 0.002);
  const Vectors moved = sum (noisy, smoothed (asPositions (noisy), k (), wideningOptions (isFast ())).displacements);
  const auto meanOffset = [&] (const Vectors& points, float z) {
    double sum = 0;
    for (std::size_t i = 0; i < points.size (); ++i)
      if (walls[i].z () == z)
        sum += std::abs (points[i].z () - z);
    return sum;
  };
  for (const float z : {1.0f, 5.0f})
    EXPECT_LT (meanOffset (moved, z), 0.25 * meanOffset (noisy, z)) << z;
}

TEST_P (WideNoisePresets, ThinPlatesKeepTheirThickness)
{
  for (const double noise : {0.3, 0.4, 0.5}) {
    const Vectors sheets = parallelSheets (80, 0.01f, 0.02f).points;
    Vectors noisy = sheets;
    for (std::size_t i = 0; i < noisy.size (); ++i)
      noisy[i].z () += static_cast<float> (noise * 0.01 * gaussianNoise (1, i));
    const auto meanOffset = [&] (const Vectors& points) {
      double sum = 0;
      for (std::size_t i = 0; i < points.size (); ++i)
        sum += std::abs (points[i].z () - sheets[i].z ());
      return sum / static_cast<double> (points.size ());
    };
    const Vectors moved = sum (noisy, smoothed (asPositions (noisy), k (), wideningOptions (isFast ())).displacements);
    EXPECT_LT (meanOffset (moved), 0.82 * meanOffset (noisy)) << noise;
  }
}

TEST_P (WideNoisePresets, NoPointGoesFartherThanItMay)
{
  const Vectors points = bumpySphere (1.5);
  SmoothingOptions options = wideningOptions (isFast ());
  ASSERT_FALSE (wideNoiseOf (points).ratios.regions.empty ()) << "the test is of no use";
  options.rounds.max_displacement = 0.02f;
  float farthest = 0;
  for (const Eigen::Vector3f& way : smoothed (asPositions (points), k (), options).displacements)
    farthest = std::max (farthest, way.norm ());
  EXPECT_NEAR (farthest, 0.02f, 1e-6f);
}

TEST_P (WideNoisePresets, WithoutRoundsOrNoiseNothingMoves)
{
  const Vectors points = bumpySphere (1.5);
  SmoothingOptions without_rounds = wideningOptions (isFast ()), without_noise = without_rounds;
  without_rounds.rounds.count = 0;
  without_noise.rounds.noise.sigma = 0;
  for (const SmoothingOptions& options : {without_rounds, without_noise})
    for (const Eigen::Vector3f& way : smoothed (asPositions (points), k (), options).displacements)
      ASSERT_EQ (way, Eigen::Vector3f::Zero ());
}

TEST_P (WideNoisePresets, WhoseNormalsAreGivenIsNotProjected)
{
  const Vectors points = bumpySphere (1.5);
  SmoothingOptions options = wideningOptions (isFast ());
  options.normals = NormalSource::INPUT;
  Vectors normals = points;
  for (std::size_t i = 0; i < normals.size (); ++i)
    normals[i] = i % 100 == 0 ? Eigen::Vector3f::Constant (std::nanf ("")) : points[i].normalized ();
  const Vectors ways = smoothed (asPositions (points), k (), options, normals).displacements;
  for (std::size_t i = 0; i < ways.size (); i += 100)
    ASSERT_EQ (ways[i], Eigen::Vector3f::Zero ()) << "no normal, no move";
}

TEST_P (WideNoisePresets, ItIsSmoothedWhereItHidesInClumps)
{
  const Vectors points = crossingSweeps (0.004);
  SmoothingOptions options = wideningOptions (isFast ());
  EXPECT_LT (shareLeft (points, options), 0.15);
  options.widen_neighborhoods = false;
  EXPECT_GT (shareLeft (points, options), 0.8) << "the test is of no use";
}

INSTANTIATE_TEST_SUITE_P (Presets, WideNoisePresets, testing::Bool (), nameOfPreset);
} // namespace
