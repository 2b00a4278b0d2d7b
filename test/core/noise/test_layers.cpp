// SPDX-License-Identifier: BSD-3-Clause
#include "noise/layer_clouds.h"
#include "preset_test.h"

#include <core/noise/neighborhood_widening.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace
{
using namespace pcl_normal_smoothing;
using namespace pcl_normal_smoothing::core;
using namespace test_support;

constexpr int side = 90;
constexpr float spacing = layer_spacing;

using Surface = std::function<double (double x, double y)>;

/** A grid whose heights are rounded to steps. */
Vectors
inSteps (const Surface& surface, double step)
{
  Vectors points = planeGrid (side, spacing).points;
  for (auto& p : points)
    p.z () = static_cast<float> (step * std::round (surface (p.x (), p.y ()) / step));
  return points;
}

double
tilted (double x, double y)
{
  return 0.4 * x + 0.1 * y;
}

/** A hill in the middle. */
double
hill (double x, double y)
{
  const double middle = side * spacing / 2;
  return 0.3 * std::exp (-8 * ((x - middle) * (x - middle) + (y - middle) * (y - middle)));
}

bool
isInOneLayer (const Positions& nodes, const Row& row)
{
  for (std::size_t j = 1; j < row.size (); ++j)
    if (nodes.difference (row[0], row[j]).z () != 0)
      return false;
  return true;
}

bool
haveLayers (const Vectors& points)
{
  return layersOf (Searched (points)).hasLayers ();
}

/** A cylinder with caps made of rings one spacing apart. */
Vectors
cappedCylinder ()
{
  Vectors points = cylinder (188, 60, 0.3, 0.6).points;
  for (const float z : {-0.3f, 0.3f})
    for (double r = spacing; r < 0.3; r += spacing)
      for (double angle = 0; angle < 2 * M_PI; angle += spacing / r)
        points.emplace_back (static_cast<float> (r * std::cos (angle)), static_cast<float> (r * std::sin (angle)), z);
  return points;
}

/** Stairs with treads of eight spacings and risers of three. */
Vectors
stairs ()
{
  Vectors points;
  for (int stair = 0; stair < 10; ++stair)
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < 8; ++x)
        points.emplace_back (spacing * static_cast<float> (8 * stair + x), spacing * static_cast<float> (y),
                             spacing * static_cast<float> (3 * stair));
      for (int z = 1; z < 3; ++z)
        points.emplace_back (spacing * static_cast<float> (8 * stair + 8), spacing * static_cast<float> (y),
                             spacing * static_cast<float> (3 * stair + z));
    }
  return points;
}

/** Flat roofs ten spacings wide at random heights; nothing between them. */
Vectors
roofs ()
{
  Vectors points = planeGrid (side, spacing).points;
  for (auto& p : points) {
    const int roof = 9 * static_cast<int> (p.x () / (10 * spacing)) + static_cast<int> (p.y () / (10 * spacing));
    p.z () = 8 * spacing * static_cast<float> (uniformNoise (5, static_cast<std::uint64_t> (roof)));
  }
  return points;
}

double
meanError (const Vectors& points, const Surface& surface)
{
  double sum = 0;
  for (const auto& p : points)
    sum += std::abs (p.z () - surface (p.x (), p.y ()));
  return sum / static_cast<double> (points.size ());
}

TEST (LayersTest, AreSeenWhateverTheStepAndTheTurn)
{
  const Eigen::AngleAxisf turn (0.7f, Eigen::Vector3f (1, 2, 3).normalized ());
  for (const double step : {0.01, 0.02, 0.04, 0.08})
    for (const Surface& surface : {Surface (tilted), Surface (hill)}) {
      Vectors points = inSteps (surface, step);
      EXPECT_TRUE (haveLayers (points)) << step;
      for (auto& p : points)
        p = turn * p + Eigen::Vector3f (1, 2, 3);
      EXPECT_TRUE (haveLayers (points)) << step << ", turned";
    }
}

TEST (LayersTest, AreSeenWhereMostOfTheCloudHasNone)
{
  Vectors points = inSteps (tilted, 0.03);
  for (std::size_t i = 0; i < points.size (); ++i)
    points[i].z () += static_cast<float> (points[i].x () < 0.9f * side * spacing ? 0.003 * gaussianNoise (9, i) : 0);
  EXPECT_TRUE (haveLayers (points));
}

TEST (LayersTest, CleanShapesHaveNone)
{
  const Vectors plane = planeGrid (side, spacing).points;
  EXPECT_FALSE (haveLayers (plane));
  EXPECT_FALSE (haveLayers (cube (40, 0.4).points));
  EXPECT_FALSE (haveLayers (sphere (8000, 0.3).points));
  for (const float gap : {1.5f, 2.0f, 3.0f, 6.0f, 8.0f})
    EXPECT_FALSE (haveLayers (parallelSheets (side, spacing, gap * spacing).points)) << gap;
  EXPECT_FALSE (haveLayers (stairs ()));
  EXPECT_FALSE (haveLayers (roofs ()));
  EXPECT_FALSE (haveLayers (cappedCylinder ()));
  EXPECT_FALSE (haveLayers (wallWithWindows ()));
}

TEST (LayersTest, SurfacesWithNoiseHaveNone)
{
  for (const double sigma : {0.0005, 0.005}) {
    EXPECT_FALSE (haveLayers (withNoise (planeGrid (side, spacing).points, sigma, 1)));
    EXPECT_FALSE (haveLayers (withNoise (cube (40, 0.4).points, sigma, 1)));
  }
}

TEST (LayersTest, NeighbourhoodsGrowWithTheSteps)
{
  float last = -1;
  for (const double step : {0.01, 0.02, 0.04}) {
    const float halvings = layersOf (Searched (inSteps (tilted, step))).halvings.valueAt ({0.4f, 0.4f, 0.2f}, -1);
    EXPECT_GT (halvings, last + 0.9f) << step;
    last = halvings;
  }
}

TEST (LayersTest, GrowWhereTheStepsAreWide)
{
  const auto uneven = [] (double x, double y) { return 0.45 * x * x + 0.05 * y; };
  const RegionalField halvings = layersOf (Searched (inSteps (uneven, 0.015))).halvings;
  EXPECT_GT (halvings.valueAt ({0.05f, 0.4f, 0}, 0), halvings.valueAt ({0.85f, 0.4f, 0.3f}, 0) + 1);
}

TEST (LayersTest, WideRowsBeginWithTheNodeAndHoldSeveralLayers)
{
  const Searched cloud (inSteps (tilted, 0.04));
  const auto wide = widenNeighborhoods (*cloud.graph, cloud.nodes, {layersOf (cloud), {}, {}, {}}, Execution (2));
  ASSERT_TRUE (wide);
  std::size_t in_one = 0, in_one_before = 0;
  for (std::uint32_t node = 0; node < wide->size (); ++node) {
    const Row row = wide->row (node);
    ASSERT_EQ (row.size (), 32u);
    ASSERT_EQ (row[0], node);
    for (std::size_t j = 1; j < row.size (); ++j)
      ASSERT_NE (row[j], node);
    in_one += isInOneLayer (cloud.nodes, row) ? 1 : 0;
    in_one_before += isInOneLayer (cloud.nodes, cloud.graph->row (node)) ? 1 : 0;
  }
  EXPECT_LT (static_cast<double> (in_one), 0.02 * static_cast<double> (wide->size ()));
  EXPECT_GT (static_cast<double> (in_one_before), 0.2 * static_cast<double> (wide->size ())) << "the test is of no use";
}

TEST (LayersTest, RowsWithinARadiusStay)
{
  const Vectors points = inSteps (tilted, 0.02);
  const LayerEstimate layers = layersOf (Searched (points));
  const Searched cloud (points, {0, 3.5f * spacing});
  EXPECT_FALSE (widenNeighborhoods (*cloud.graph, cloud.nodes, {layers, {}, {}, {}}, Execution (2)));
}

TEST (LayersTest, ThreadsDoNotMatter)
{
  const Searched cloud (inSteps (hill, 0.02));
  const RegionalField one = layersOf (cloud, 1).halvings, two = layersOf (cloud, 2).halvings;
  EXPECT_EQ (one.values (), two.values ());
  EXPECT_GT (one.regions.size (), 4u);
}

TEST (LayersTest, TheNoiseVariesAsTheStepsDo)
{
  Vectors points = planeGrid (side, spacing).points;
  for (auto& p : points) { // a depth camera measures the reciprocal of the depth in steps
    const float depth = 1 / (0.01f * std::round (100 / (1 + 2 * p.x ())));
    p = depth * Eigen::Vector3f (p.x (), p.y (), 1);
  }
  const Searched cloud (points);
  const NoiseEstimate noise = estimateNoise (*cloud.graph, cloud.nodes, Execution (2));
  EXPECT_GT (noise.field.factorAt (2.6f * Eigen::Vector3f (0.8f, 0.4f, 1)),
             2 * noise.field.factorAt (1.2f * Eigen::Vector3f (0.1f, 0.4f, 1)));
}

TEST (LayersTest, TheNoiseIsThatOfTheSteps)
{
  for (const double step : {0.01, 0.02, 0.04}) {
    const Searched cloud (inSteps (tilted, step));
    const NoiseEstimate noise = estimateNoise (*cloud.graph, cloud.nodes, Execution (2));
    EXPECT_GT (noise.sigma, step / std::sqrt (12.0)) << step;
    EXPECT_LT (noise.sigma, 0.4 * step) << step;
    EXPECT_NEAR (noise.spacing, spacing, 0.2 * spacing) << "of the cloud, not of the wide neighbourhoods";
  }
}

TEST (LayersTest, NoiseBeforeTheRoundingFraysTheStepsAndCounts)
{
  const double step = 0.02;
  const auto frayed = [&] (double x, double y) { return tilted (x, y) + 0.5 * step * patchNoise (x, y); };
  const Searched clear (inSteps (tilted, step)), noisy (inSteps (frayed, step));
  ASSERT_TRUE (layersOf (noisy).hasLayers ());
  EXPECT_GT (layersOf (noisy).noise_of_step, layersOf (clear).noise_of_step + 0.1f);
}

TEST (LayersTest, LayersOfAWallThatFacesTheCameraAreNoSheets)
{
  const double step = 0.065;
  const Vectors points = inSteps ([&] (double x, double y) { return 0.05 * x + 0.6 * step * patchNoise (x, y); }, step);
  const SmoothingOptions options = prepared (wideningOptions (false), Searched (points));
  ASSERT_TRUE (options.widen_neighborhoods);
  EXPECT_GT (options.rounds.sheet_distance, step);
}

TEST (LayersTest, FewNeighboursAreEnough)
{
  const Vectors points = inSteps (tilted, 0.02);
  const SmoothingOptions options = prepared (wideningOptions (false), Searched (points, {8}));
  EXPECT_TRUE (options.widen_neighborhoods);
  EXPECT_GT (options.rounds.noise.sigma, 0.005f);
  EXPECT_LT (options.rounds.noise.field.largestFactor (), 1.5f);
}

class LayersPresets : public PresetTest
{};

TEST_P (LayersPresets, WideStepsAreSmoothed)
{
  for (const double step : {0.02, 0.04})
    for (const Surface& surface : {Surface (tilted), Surface (hill)}) {
      const Vectors points = inSteps (surface, step);
      SmoothingOptions options = wideningOptions (isFast ());
      const double before = meanError (points, surface);
      const Vectors widened = sum (points, smoothed (asPositions (points), k (), options).displacements);
      EXPECT_LT (meanError (widened, surface), 0.6 * before) << step;
      options.widen_neighborhoods = false;
      const Vectors stuck = sum (points, smoothed (asPositions (points), k (), options).displacements);
      EXPECT_GT (meanError (stuck, surface), 0.9 * before) << step << ": the test is of no use";
    }
}

INSTANTIATE_TEST_SUITE_P (Presets, LayersPresets, testing::Bool (), nameOfPreset);

TEST (LayersTest, HideTheNoise)
{
  EXPECT_EQ (noiseHiddenBy (inSteps (tilted, 0.02)), NoiseHiddenBy::LAYERS);
}
} // namespace
