// SPDX-License-Identifier: BSD-3-Clause
#include "searched.h"

#include <core/search/hash_sample.h>
#include <core/sheets/sheet_criterion.h>
#include <core/sheets/sheet_estimate.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace
{
using namespace pcl_normal_smoothing::core;
using namespace test_support;

constexpr float spacing = 0.02f;

SheetSample
sampleOf (const Searched& cloud, float distance, unsigned threads = 2)
{
  const Execution execution (threads);
  return sampleSheets (*cloud.graph, cloud.nodes, sampleNodes (cloud.nodes, sheet_sample_size, execution),
                       {distance, sheet_row_length}, execution);
}

TEST (SheetEstimateTest, SeesHowFarApartSheetsAreAndTheirNoise)
{
  const std::pair<float, float> sheets[] = {{1, .1f}, {1.2f, .15f}, {1.5f, .2f}, {2, .2f}, {3, .2f}};
  for (const auto& [gap, noise] : sheets) {
    const Searched cloud (withNormalNoise (parallelSheets (60, spacing, gap * spacing), noise * spacing, 3));
    const float distance = std::min (1.2f, 4.5f * noise) * spacing;
    const SheetEstimate estimate = estimateSheets (sampleOf (cloud, distance), distance);
    EXPECT_NEAR (estimate.gap / spacing, gap, .2 * gap);
    EXPECT_NEAR (estimate.sigma / spacing, noise, .25 * noise) << gap << " spacings apart";
  }
}

/** Bumps as fine as the sampling and higher than the noise: neighbours lie far from the tangent planes, but on the same
  * sheet. */
Shape
bumpyPlane ()
{
  Shape shape = planeGrid (80, spacing);
  for (auto& point : shape.points)
    point.z () += 0.8f * spacing * std::sin (point.x () * 1.3f / spacing) * std::sin (point.y () * 1.1f / spacing);
  return shape;
}

TEST (SheetEstimateTest, SeesNoneWhereThereIsOneSheet)
{
  const Shape shapes[] = {planeGrid (60, spacing), sphere (8000, .5), cube (30, .6),
                          torus (5000, .4, .1),    bumpyPlane (),     parallelSheets (60, spacing, 8 * spacing)};
  for (const Shape& shape : shapes)
    for (const float noise : {0.0f, .05f, .2f, .5f})
      for (const float distance : {4 * noise * spacing, 1.2f * spacing}) {
        const Searched cloud (withNormalNoise (shape, noise * spacing, 3));
        EXPECT_EQ (estimateSheets (sampleOf (cloud, distance), distance).gap, 0)
            << "shape " << &shape - shapes << ", noise " << noise << ", distance " << distance / spacing;
      }
}

TEST (SheetEstimateTest, LayersOfADepthCameraAreNoSheets)
{
  for (const float slope : {.2f, .35f, .5f})
    for (const float step : {.6f, 1.0f, 1.5f}) {
      Vectors points = planeGrid (60, spacing).points;
      for (auto& point : points)
        point.z () = step * spacing * std::round (slope * point.x () / (step * spacing));
      const float distance = .4f * step * spacing;
      EXPECT_EQ (estimateSheets (sampleOf (Searched (points), distance), distance).gap, 0)
          << "slope " << slope << ", steps of " << step;
    }
}

TEST (SheetEstimateTest, CleanSheetsAreSheets)
{
  for (const float gap : {1.0f, 1.5f, 2.0f, 2.5f}) {
    const Searched cloud (parallelSheets (60, spacing, gap * spacing).points);
    EXPECT_NEAR (estimateSheets (sampleOf (cloud, .8f * spacing), .8f * spacing).gap / spacing, gap, .01f);
  }
}

TEST (SheetEstimateTest, ASampleIsAsGoodAsTheWholeCloud)
{
  const Searched small (withNormalNoise (parallelSheets (20, spacing, 1.5f * spacing), .2f * spacing, 3));
  EXPECT_EQ (sampleOf (small, .8f * spacing).nodes, small.nodes.size ());
  const Searched large (withNormalNoise (parallelSheets (150, spacing, 1.5f * spacing), .2f * spacing, 3));
  const SheetSample sample = sampleOf (large, .8f * spacing);
  EXPECT_NEAR (static_cast<double> (sample.nodes), 1024, 128);
  EXPECT_NEAR (estimateSheets (sample, .8f * spacing).gap, 1.5f * spacing, .15f * spacing);
}

TEST (SheetEstimateTest, PartsMakeTheWhole)
{
  const Searched cloud (withNormalNoise (parallelSheets (40, spacing, 1.5f * spacing), .2f * spacing, 3));
  const float distance = .8f * spacing;
  const Execution execution (2);
  std::vector<std::uint32_t> parts[2];
  for (const std::uint32_t node : sampleNodes (cloud.nodes, sheet_sample_size, execution))
    parts[node % 3 == 0].push_back (node);
  const SheetScale scale {distance, sheet_row_length};
  SheetSample joined = sampleSheets (*cloud.graph, cloud.nodes, parts[0], scale, execution);
  joined.join (sampleSheets (*cloud.graph, cloud.nodes, parts[1], scale, execution));
  const SheetEstimate expected = estimateSheets (sampleOf (cloud, distance, 1), distance);
  const SheetEstimate actual = estimateSheets (joined, distance);
  EXPECT_GT (expected.gap, 0);
  EXPECT_EQ (actual.gap, expected.gap);
  EXPECT_EQ (actual.sigma, expected.sigma);
}

TEST (SheetEstimateTest, ASheetLiesAllAround)
{
  SheetSample sample =
      sampleOf (Searched (withNormalNoise (parallelSheets (60, spacing, 1.5f * spacing), .2f * spacing, 3)),
                .8f * spacing);
  const auto gapWithSides = [&] (float side) {
    std::fill (sample.sides.begin (), sample.sides.end (), side);
    return estimateSheets (sample, .8f * spacing).gap;
  };
  EXPECT_GT (gapWithSides (.55f), 0);
  EXPECT_EQ (gapWithSides (.7f), 0) << "as in a ball inside wide noise";
}

TEST (SheetEstimateTest, NothingGivesNothing)
{
  EXPECT_EQ (estimateSheets (SheetSample (), 1).gap, 0);
  const Searched point (Vectors (1, Eigen::Vector3f (1, 2, 3)));
  EXPECT_EQ (estimateSheets (sampleOf (point, 1), 1).gap, 0);
  const Searched copies (Vectors (100, Eigen::Vector3f (1, 2, 3)));
  EXPECT_EQ (estimateSheets (sampleOf (copies, 1), 1).gap, 0);
}
} // namespace
