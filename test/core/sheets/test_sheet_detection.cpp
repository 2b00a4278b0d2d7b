// SPDX-License-Identifier: BSD-3-Clause
#include "searched.h"
#include "shapes.h"

#include <core/search/hash_sample.h>
#include <core/sheets/sheet_detection.h>

#include <gtest/gtest.h>

namespace
{
using namespace pcl_normal_smoothing::core;
using namespace test_support;

constexpr float spacing = 0.02f;

/** \param[in] noise in spacings, along the normals; also given to the detection */
SheetDetection
sightOf (const Shape& shape, float noise, std::uint32_t k)
{
  const Searched cloud (withNormalNoise (shape, noise * spacing, 3), {k});
  const Execution execution (2);
  return detectSheets (*cloud.graph, cloud.nodes, sampleNodes (cloud.nodes, sheet_sample_size, execution),
                       sheetScales (noise * spacing, spacing), execution);
}

class SheetDetectionTest : public testing::TestWithParam<std::uint32_t>
{};

TEST_P (SheetDetectionTest, SeeSheetsThatAreAsCloseAsTheirPoints)
{
  const std::pair<float, float> sheets[] = {{1, .1f}, {1, .2f}, {1.2f, .2f}, {1.5f, .2f}, {1.5f, .3f}, {2, .2f}};
  for (const auto& [gap, noise] : sheets) {
    const SheetDetection detected = sightOf (parallelSheets (60, spacing, gap * spacing), noise, GetParam ());
    EXPECT_NEAR (detected.estimate.gap / spacing, gap, .2 * gap) << "noise " << noise;
    EXPECT_TRUE (detected.may_exist);
  }
}

TEST_P (SheetDetectionTest, SeeNoneWhereThereIsOneSheet)
{
  const Shape shapes[] = {planeGrid (60, spacing), sphere (8000, .5), cube (30, .6), torus (5000, .4, .1)};
  for (const Shape& shape : shapes)
    for (const float noise : {0.0f, .05f, .2f, .5f}) {
      const SheetDetection detected = sightOf (shape, noise, GetParam ());
      EXPECT_EQ (detected.estimate.gap, 0) << "shape " << &shape - shapes << ", noise " << noise;
      EXPECT_FALSE (detected.may_exist) << "shape " << &shape - shapes << ", noise " << noise;
    }
}

INSTANTIATE_TEST_SUITE_P (Rows, SheetDetectionTest, testing::Values (32u, 16u));

TEST (SheetDetectionTest, SheetsMayBeLostInTheNoise)
{
  const SheetDetection detected = sightOf (parallelSheets (60, spacing, 2.5f * spacing), .5f, 32);
  EXPECT_EQ (detected.estimate.gap, 0) << "the test is of no use";
  EXPECT_TRUE (detected.may_exist);
}

TEST (SheetDetectionTest, LooksAtTheSameAreOne)
{
  // Rows within a radius differ in length: those of the sample are shorter than the longest.
  const Searched cloud (parallelSheets (40, spacing, 1.2f * spacing).points, {32, 2.2f * spacing});
  const Execution execution (2);
  const std::vector<std::uint32_t> sample = sampleNodes (cloud.nodes, sheet_sample_size, execution);
  for (const float sigma : {.1f * spacing, .2f * spacing}) {
    const SheetScales scales = sheetScales (sigma, spacing);
    SheetSamples samples;
    for (std::size_t i = 0; i < scales.size (); ++i)
      samples[i] = sampleSheets (*cloud.graph, cloud.nodes, sample, scales[i], execution);
    const SheetEstimate expected = decideSheets (samples, scales).estimate;
    const SheetEstimate actual = detectSheets (*cloud.graph, cloud.nodes, sample, scales, execution).estimate;
    EXPECT_EQ (actual.gap, expected.gap);
    EXPECT_EQ (actual.sigma, expected.sigma);
  }
}

TEST (SheetDetectionTest, NothingGivesNothing)
{
  EXPECT_EQ (decideSheets ({}, sheetScales (1, 1)).estimate.gap, 0);
  EXPECT_FALSE (decideSheets ({}, sheetScales (1, 1)).may_exist);
}
} // namespace
