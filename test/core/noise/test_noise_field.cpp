// SPDX-License-Identifier: BSD-3-Clause
#include "shapes.h"

#include <core/noise/noise_field_estimate.h>
#include <pcl_normal_smoothing/core/noise/noise_estimate.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace pcl_normal_smoothing::core;
using namespace test_support;

constexpr std::size_t sphere_size = 6000;
const double sphere_spacing = std::sqrt (4 * M_PI / sphere_size);

NoiseEstimate
estimateOf (const Vectors& points)
{
  const auto graph = NeighborGraph::build (asPositions (points), {16}, Execution (2));
  return estimateNoise (*graph, gather (asPositions (points), graph->order ()), Execution (2));
}

double
growing (const Eigen::Vector3f& place)
{
  return sphere_spacing * (0.25 + 0.2 * place.x ());
}

TEST (NoiseFieldTest, TellsWhereTheNoiseIsLarge)
{
  for (const std::uint64_t seed : {3, 4, 5}) {
    const NoiseEstimate noise = estimateOf (withNormalNoise (sphere (sphere_size, 1), growing, seed));
    ASSERT_FALSE (noise.field.isEven ());
    for (const float x : {-0.8f, -0.4f, 0.0f, 0.4f, 0.8f})
      for (const Eigen::Vector3f& place :
           {Eigen::Vector3f (x, std::sqrt (1 - x * x), 0), Eigen::Vector3f (x, 0, -std::sqrt (1 - x * x))}) {
        EXPECT_GT (noise.sigma * noise.field.factorAt (place), 0.75 * growing (place)) << x;
        EXPECT_LT (noise.sigma * noise.field.factorAt (place), 1.7 * growing (place)) << x;
      }
  }
}

TEST (NoiseFieldTest, EvenNoiseHasHardlyAny)
{
  const std::pair<Shape, double> shapes[] = {{sphere (sphere_size, 1), sphere_spacing},
                                             {planeGrid (80, 0.01f), 0.01},
                                             {cube (40, 1), 1.0 / 40},
                                             {torus (9000, 1, 0.4), 0.042}};
  for (const double ratio : {0.05, 0.1, 0.2, 0.3, 0.5})
    for (const std::uint64_t seed : {3, 4, 5})
      for (const auto& [shape, spacing] : shapes) {
        const double sigma = ratio * spacing;
        const NoiseField field = estimateOf (withNormalNoise (shape, sigma, seed)).field;
        EXPECT_LT (field.largestFactor () / field.smallestFactor (), 1.15f)
            << ratio << " of the shape of " << shape.size () << " points";
      }
}

TEST (NoiseFieldTest, DetailInsideOfRegionsIsNoNoiseThatVaries)
{
  for (const double pitch : {10, 14, 20})
    for (const double sigma : {0.01, 0.02, 0.05})
      EXPECT_TRUE (estimateOf (withNormalNoise (groovedPlate (pitch), sigma, 3)).field.isEven ())
          << pitch << ' ' << sigma;
}

TEST (NoiseFieldTest, OneNoiseIsNoDetail)
{
  std::vector<LocalValue> variances;
  for (std::uint64_t i = 0; i < 4000; ++i) {
    float sum = 0; // chi-square distributed with six degrees of freedom
    for (std::uint64_t seed = 0; seed < 6; ++seed)
      sum += static_cast<float> (std::pow (gaussianNoise (seed, i), 2));
    variances.push_back ({Eigen::Vector3f (static_cast<float> (i), 0, 0), sum});
  }
  EXPECT_EQ (certaintyOfDetail (variances, 1), 0);
  for (LocalValue& variance : variances) // noise that varies from region to region
    variance.value *= 1 + 1e-3f * variance.place.x ();
  EXPECT_EQ (certaintyOfDetail (variances, 1), 0);
  for (std::size_t i = 0; i < variances.size (); i += 3)
    variances[i].value *= 25;
  EXPECT_EQ (certaintyOfDetail (variances, 1), 1);
  variances.resize (2000);
  EXPECT_EQ (certaintyOfDetail (variances, 1), 0) << "regions are too large a part";
}

TEST (NoiseFieldTest, OrderDoesNotMatter)
{
  const auto growing_along_x = [] (const Eigen::Vector3f& p) { return 0.001 + 0.005 * p.x (); };
  Vectors points = withNormalNoise (planeGrid (80, 0.01f), growing_along_x, 3);
  for (std::size_t i = 0; i < points.size (); i += 7)
    points.push_back (points[i]); // copies, whose order is ambiguous
  const NoiseField expected = estimateOf (points).field;
  ASSERT_FALSE (expected.isEven ());
  const NoiseField field = estimateOf (shuffled (points, 4)).field;
  ASSERT_EQ (field.factors.regions.size (), expected.factors.regions.size ());
  for (std::size_t i = 0; i < field.factors.regions.size (); ++i) {
    EXPECT_EQ (field.factors.regions[i].centre, expected.factors.regions[i].centre);
    EXPECT_EQ (field.factors.regions[i].reach, expected.factors.regions[i].reach);
    EXPECT_EQ (field.factors.regions[i].value, expected.factors.regions[i].value);
  }
}

TEST (NoiseFieldTest, IsTheSameInAnotherUnit)
{
  const NoiseField field {{{{{1, 0, 0}, 0.5f, 2}, {{-1, 0, 0}, 1, 0.5f}}}}, other = field.inUnit (0.25);
  for (const float x : {-2.0f, -1.0f, 0.0f, 0.7f})
    EXPECT_EQ (other.factorAt ({4 * x, 4, 0}), field.factorAt ({x, 1, 0}));
}

TEST (NoiseFieldTest, LiesBetweenItsRegionsAndIsOneFarAway)
{
  const NoiseField field {{{{{1, 0, 0}, 0.5f, 2}, {{-1, 0, 0}, 0.5f, 0.5f}}}};
  EXPECT_NEAR (field.factorAt ({1, 0, 0}), 2, 0.01);
  EXPECT_NEAR (field.factorAt ({-1, 0, 0}), 0.5, 0.01);
  EXPECT_EQ (field.factorAt ({0, 3, 0}), 1.25f);
  EXPECT_EQ (field.factorAt ({1e30f, 0, 0}), 1);
  EXPECT_EQ (NoiseField ().factorAt ({1, 0, 0}), 1);
}

TEST (NoiseFieldTest, WherePartOfACloudIsCleanFactorsStayWithinBounds)
{
  for (const float border : {0.2f, 0.6f}) {
    const auto behind_border = [&] (const Eigen::Vector3f& p) { return p.x () < border ? 0 : 0.002; };
    const Vectors points = withNormalNoise (planeGrid (80, 0.01f), behind_border, 3);
    const NoiseField field = estimateOf (points).field;
    for (const auto& point : points) {
      EXPECT_GE (field.factorAt (point), 0.031f);
      EXPECT_LE (field.factorAt (point), 32.01f);
    }
  }
}
} // namespace
