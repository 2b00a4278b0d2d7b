// SPDX-License-Identifier: BSD-3-Clause
#include "noise/wide_clouds.h"
#include "smoothed.h"

#include <core/noise/differences.h>
#include <core/noise/neighborhood_widening.h>
#include <core/whole_cloud.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace pcl_normal_smoothing;
using namespace pcl_normal_smoothing::core;
using namespace test_support;

RegionalField
halvingsOf (const Vectors& points, unsigned threads = 2)
{
  return wideNoiseOf (points, threads).halvings;
}

/** A square with waves of the given length. */
Vectors
waves (double noise, double length)
{
  Vectors points = square (noise);
  for (Eigen::Vector3f& point : points)
    point.z () += static_cast<float> (0.1 * length * std::sin (2 * M_PI * point.x () / length));
  return points;
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
  const WideNoise of_detail = wideNoiseOf (waves (1, 0.15)), of_long_waves = wideNoiseOf (waves (1, 5));
  EXPECT_NEAR (of_detail.ratios.valueAt ({.5f, .5f, 0}, 0), 1, 0.3f);
  EXPECT_TRUE (of_long_waves.ratios.regions.empty ()) << "as wide as the square: no detail";
  EXPECT_GT (of_long_waves.halvings.valueAt ({.5f, .5f, 0}, -1),
             halvingsOf (square (1)).valueAt ({.5f, .5f, 0}, -1) - 0.5f);
}

TEST (WideNoiseTest, OtherCloudsAreAsTheyAre)
{
  EXPECT_EQ (wideNoiseOf (square (0)).sigma, 0);
  EXPECT_EQ (wideNoiseOf (square (0.2)).sigma, 0);
  for (const double noise : {0.1, 0.3})
    EXPECT_EQ (wideNoiseOf (withNoise (sphere (8000, 1).points, noise * 0.04, 1)).sigma, 0) << noise;
}

TEST (WideNoiseTest, ClumpsHideIt)
{
  EXPECT_GT (halvingsOf (crossingSweeps (0.006)).valueAt ({.5f, .5f, 0}, -1), 1.5f);
  EXPECT_GT (halvingsOf (crossingSweeps (0.003)).valueAt ({.5f, .5f, 0}, -1), 0.5f);
}

TEST (WideNoiseTest, FramesOfAStillCameraHideIt)
{
  for (const double noise : {0.2, 0.5}) {
    const WideNoise wide = wideNoiseOf (framesOfAStillCamera (noise, 0));
    EXPECT_GT (wide.sigma, 0.75 * noise);
    EXPECT_LT (wide.sigma, 1.25 * noise);
    EXPECT_TRUE (wide.is_everywhere);
  }
  EXPECT_EQ (wideNoiseOf (framesOfAStillCamera (0.001, 0)).sigma, 0);
}

TEST (WideNoiseTest, TwoSheetsInClumpsAreNone)
{
  for (const double noise : {0.05, 0.1, 0.2})
    EXPECT_EQ (wideNoiseOf (framesOfAStillCamera (noise, 1)).sigma, 0) << noise;
}

TEST (WideNoiseTest, DetailIsNoClumps)
{
  for (const double noise : {0.6, 0.7, 0.8})
    EXPECT_EQ (wideNoiseOf (pits (noise)).sigma, 0) << noise;
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
  EXPECT_EQ (wideNoiseOf (leaves (wide_count)).sigma, 0);
}

TEST (WideNoiseTest, ASurfaceIsSeenInNoiseOfManySpacings)
{
  for (const double noise : {2.6, 3.0, 3.5})
    EXPECT_GT (wideNoiseOf (bumpySphere (noise)).sigma, .8 * noise * std::sqrt (4 * M_PI) * wide_spacing) << noise;
}

TEST (WideNoiseTest, OfAPartOfTheCloud)
{
  const WideNoise wide = wideNoiseOf (withNoiseOfDepth (twoWalls (1, 5), 0.002));
  EXPECT_FALSE (wide.is_everywhere);
  const Eigen::Vector3f near (-.25f, 0, 1), far (2, 0, 5);
  EXPECT_LT (wide.halvings.valueAt (near, -1), .5f) << "neighbourhoods would grow";
  EXPECT_GT (wide.halvings.valueAt (far, -1), 1);
  EXPECT_GT (wide.sigma * wide.field.factorAt (far), 0.85 * 0.002 * 25);
  EXPECT_LT (wide.sigma * wide.field.factorAt (far), 1.15 * 0.002 * 25);
  EXPECT_LT (wide.sigma * wide.field.factorAt (near), 0.3 * 0.002 * 25);
}

TEST (WideNoiseTest, OfManyPartsEachIsReadForItself)
{
  Vectors points;
  for (std::uint64_t i = 0; i < 3 * wide_count; ++i) { // the noise grows along x, from .2 to 4 spacings
    const double x = 3 * uniformNoise (1, i), noise = (.2 + 3.8 * x / 3) * wide_spacing;
    points.push_back (Eigen::Vector3d (x, uniformNoise (2, i), noise * gaussianNoise (3, i)).cast<float> ());
  }
  const WideNoise wide = wideNoiseOf (points);
  float last = 0;
  for (const float x : {1.f, 1.75f, 2.5f}) {
    const Eigen::Vector3f place (x, .5f, 0);
    const double sigma = (.2 + 3.8 * x / 3) * wide_spacing;
    EXPECT_NEAR (wide.sigma * wide.field.factorAt (place), sigma, .15 * sigma) << x;
    EXPECT_GT (wide.halvings.valueAt (place, 0), last) << x;
    last = wide.halvings.valueAt (place, 0);
  }
}

TEST (WideNoiseTest, HeightsOfTwoSheetsAreBimodalThoseOfNoiseAreNot)
{
  constexpr std::uint64_t count = 32, clouds = 100;
  const auto meanBimodality = [] (double between, double share) {
    double sum = 0;
    for (std::uint64_t cloud = 0; cloud < clouds; ++cloud) {
      Differences differences;
      for (std::uint64_t i = cloud * count; i < (cloud + 1) * count; ++i)
        differences.emplace_back (20 * uniformNoise (1, i), 20 * uniformNoise (2, i),
                                  gaussianNoise (3, i) + (uniformNoise (4, i) < share ? between : 0));
      sum += bimodality (differences) / clouds;
    }
    return sum;
  };
  EXPECT_LT (meanBimodality (0, 0), 0.45);
  for (const double share : {0.2, 0.5})
    EXPECT_GT (meanBimodality (6, share), 0.6) << share;
}

TEST (WideNoiseTest, ThinWallsInAPartAreNone)
{
  for (const float gap : {0.02f, 0.026f, 0.03f}) {
    Vectors points = planeGrid (140, 0.01f).points;
    const std::size_t on_one_side = points.size ();
    for (std::size_t i = 0; i < on_one_side; ++i)
      if (points[i].x () < .4f && points[i].y () < .4f)
        points.push_back (points[i] + Eigen::Vector3f (.005f, .005f, gap * (1 + points[i].x ())));
    EXPECT_EQ (wideNoiseOf (withNoise (points, 0.001, 1)).sigma, 0) << gap;
  }
}

/** Two walls; the near one, most of the cloud, has its noise multiplied by \a share. */
Vectors
wallsWithQuietNearOne (float share)
{
  const Vectors walls = twoWalls (1, 5);
  Vectors points = withNoiseOfDepth (walls, 0.002);
  for (std::size_t i = 0; i < points.size (); ++i)
    if (walls[i].z () == 1)
      points[i] = walls[i] + share * (points[i] - walls[i]);
  return points;
}

TEST (WideNoiseTest, OfAPartBesideWhatHasLittle)
{
  for (const float share : {0.1f, 0.01f}) {
    const WideNoise wide = wideNoiseOf (wallsWithQuietNearOne (share));
    EXPECT_GT (wide.sigma, 0) << share;
    EXPECT_LT (wide.halvings.valueAt ({-.25f, 0, 1}, -1), .5f) << share;
    EXPECT_GT (wide.halvings.valueAt ({2, 0, 5}, -1), 1) << share;
    for (const RegionalField::Region& region : wide.field.factors.regions)
      EXPECT_TRUE (std::isfinite (region.value) && region.value > 0) << share;
  }
}

TEST (WideNoiseTest, OfAPartNoneIsSeenBesideWhatIsClean)
{
  const WideNoise wide = wideNoiseOf (wallsWithQuietNearOne (0)); // its usual noise is 0, so no noise has a ratio to it
  EXPECT_EQ (wide.sigma, 0);
  EXPECT_TRUE (wide.halvings.regions.empty ());
  EXPECT_TRUE (wide.field.isEven ());
}

TEST (WideNoiseTest, ThreadsAndOrderDoNotMatter)
{
  for (const Vectors& points : {square (1), withNoiseOfDepth (twoWalls (1, 5), 0.002)}) {
    const WideNoise expected = wideNoiseOf (points, 1);
    EXPECT_FALSE (expected.halvings.regions.empty ());
    for (const WideNoise& other : {wideNoiseOf (points), wideNoiseOf (shuffled (points, 4))}) {
      EXPECT_EQ (other.halvings.values (), expected.halvings.values ());
      EXPECT_EQ (other.field.factors.values (), expected.field.factors.values ());
      EXPECT_EQ (other.sigma, expected.sigma);
    }
  }
}

TEST (WideNoiseTest, AllOfTheNoiseIsRead)
{
  for (const double noise : {0.5, 1.0, 2.0}) {
    const Searched cloud (square (noise));
    const NoiseEstimate read = estimateNoise (*cloud.graph, cloud.nodes, Execution (2));
    EXPECT_NEAR (read.sigma / (noise * wide_spacing), 1, 0.2) << noise;
    EXPECT_LT (read.spacing, 3 * wide_spacing) << "of the cloud, not of the wide neighbourhoods";
  }
  const Searched bumps (bumpySphere (1.5)); // where points are projected
  const NoiseEstimate read = estimateNoise (*bumps.graph, bumps.nodes, Execution (2));
  EXPECT_NEAR (read.sigma / (1.5 * std::sqrt (4 * M_PI) * wide_spacing), 1, 0.2);
}

/** The ratio of the sigma that the smoothing uses to the estimated one. */
float
takenOverRead (const Vectors& points)
{
  const Searched cloud (points);
  const SmoothingOptions options = prepared (wideningOptions (false), cloud);
  return options.rounds.noise.sigma / estimateNoise (*cloud.graph, cloud.nodes, Execution (2)).sigma;
}

TEST (WideNoiseTest, SmoothingTakesItToBeLargerThanItIsRead)
{
  EXPECT_NEAR (takenOverRead (square (0.2)), 1, 0.01);
  EXPECT_NEAR (takenOverRead (square (1)), 1.5, 0.01);
}

TEST (WideNoiseTest, NotSoMuchLargerWhereThereIsDetail)
{
  EXPECT_NEAR (takenOverRead (waves (0.4, 0.1)), 1.2, 0.01);
  EXPECT_NEAR (takenOverRead (waves (0.6, 0.1)), 1.2, 0.01);
  EXPECT_NEAR (takenOverRead (square (0.4)), 1.5, 0.01) << "has no detail to lose";
}

TEST (WideNoiseTest, OfAPartItIsSoThereAlone)
{
  const Searched cloud (withNoiseOfDepth (twoWalls (1, 5), 0.002));
  const SmoothingOptions options = prepared (wideningOptions (false), cloud);
  const NoiseEstimate read = estimateNoise (*cloud.graph, cloud.nodes, Execution (2)), &taken = options.rounds.noise;
  const auto takenOverReadAt = [&] (const Eigen::Vector3f& place) {
    return taken.sigma * taken.field.factorAt (place) / (read.sigma * read.field.factorAt (place));
  };
  EXPECT_NEAR (takenOverReadAt ({2, 0, 5}), 1.5, 0.1);
  EXPECT_LT (takenOverReadAt ({-.25f, 0, 1}), 1.35f) << "regions count for each other, but little";
}

TEST (WideNoiseTest, SoItDoesOfEvenPointsWhereItIsReadInPart)
{
  const Shape ball = sphere (8000, 1);
  EXPECT_NEAR (takenOverRead (withNormalNoise (ball, 0.3 * 0.04, 1)), 1, 0.01);
  EXPECT_NEAR (takenOverRead (withNormalNoise (ball, 0.8 * 0.04, 1)), 1.6, 0.01);
}

TEST (WideNoiseTest, HidesItself)
{
  for (const Vectors& wide : {square (1), waves (1, 0.15), withNoiseOfDepth (twoWalls (1, 5), 0.002)})
    EXPECT_EQ (noiseHiddenBy (wide), NoiseHiddenBy::WIDTH);
  EXPECT_EQ (noiseHiddenBy (square (0.2)), NoiseHiddenBy::NOTHING);
}
} // namespace
