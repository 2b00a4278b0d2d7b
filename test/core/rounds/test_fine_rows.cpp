// SPDX-License-Identifier: BSD-3-Clause
#include "searched.h"
#include "smoothed.h"

#include <core/rounds/fine_rows.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace pcl_normal_smoothing::core;
using namespace test_support;

constexpr float middle = 20; // of a plane 40 wide

/** A plane with half the spacing in its right half. */
Vectors
unevenPlane ()
{
  Vectors points;
  for (const auto& point : planeGrid (40, 1).points)
    if (point.x () < middle)
      points.push_back (point);
  for (const auto& point : planeGrid (80, 0.5f).points)
    if (point.x () >= middle)
      points.push_back (point);
  return points;
}

/** An even plane of spacing 1, and one whose spacing halves in the middle; k = 32. */
class FineRowsTest : public testing::Test
{
protected:
  FineRows
  rowsOf (const Searched& cloud, float sigma, const Numbers& variance_factors = {}) const
  {
    return {*cloud.graph, cloud.nodes, sigma, variance_factors, Execution (2)};
  }

  /** Number of neighbours used for a node, itself included. */
  static std::size_t
  sizeOfRow (const Searched& cloud, const FineRows& rows, std::size_t node)
  {
    const std::size_t block = node / block_size, lane = node % block_size;
    const BlockRows all {cloud.graph->blockRows (block), cloud.graph->blockLength (block)};
    FineRows::Buffer buffer;
    const BlockRows fine = rows.ofBlock (all, buffer);
    std::size_t size = 1;
    for (std::size_t j = 1; j < fine.length; ++j)
      if (const std::uint32_t neighbor = fine.neighbors[j * block_size + lane]; neighbor != node) {
        EXPECT_EQ (neighbor, all.neighbors[j * block_size + lane]);
        ++size;
      }
    return size;
  }

  const Searched even_ {planeGrid (40, 1).points}, uneven_ {unevenPlane ()};
};

TEST_F (FineRowsTest, WhereTheNoiseIsNarrowAllAreFine)
{
  const FineRows rows = rowsOf (even_, .5f);
  EXPECT_TRUE (rows.areAllFine ());
  EXPECT_EQ (sizeOfRow (even_, rows, 777), fine_k);
  EXPECT_TRUE (rows.scaledWhereWide (nullptr, 2).empty ());
}

TEST_F (FineRowsTest, WhereItIsWideNoneIs)
{
  const FineRows rows = rowsOf (even_, 1);
  for (const std::size_t node : {0, 777, 1599})
    EXPECT_EQ (sizeOfRow (even_, rows, node), max_row_length);
}

TEST_F (FineRowsTest, NoneIsWiderThanTheRowsOfTheGraph)
{
  const Searched short_rows (planeGrid (40, 1).points, {fine_k});
  const FineRows rows = rowsOf (short_rows, 1);
  EXPECT_TRUE (rows.areAllFine ());
  EXPECT_EQ (sizeOfRow (short_rows, rows, 777), fine_k);
}

TEST_F (FineRowsTest, DensePlacesAreWideFirst)
{
  const FineRows rows = rowsOf (uneven_, .45f);
  ASSERT_FALSE (rows.areAllFine ());
  const Numbers factors (uneven_.graph->size (), 3), scaled = rows.scaledWhereWide (factors.data (), 2),
                                                     plain = rows.scaledWhereWide (nullptr, 2);
  std::size_t fine = 0, wide = 0;
  for (std::uint32_t node = 0; node < uneven_.graph->size (); ++node) {
    const float x = uneven_.nodes.base[node].x () - middle;
    if (std::abs (x) < 4) // at the transition
      continue;
    EXPECT_EQ (sizeOfRow (uneven_, rows, node), x < 0 ? fine_k : max_row_length) << x;
    EXPECT_EQ (scaled[node], x < 0 ? 3 : 6);
    EXPECT_EQ (plain[node], x < 0 ? 1 : 2);
    ++(x < 0 ? fine : wide);
  }
  EXPECT_GT (fine, 500u);
  EXPECT_GT (wide, 2000u);
}

TEST_F (FineRowsTest, NoiseIsWideWhereItIsLarger)
{
  Numbers variance_factors (even_.graph->size (), 1);
  for (std::size_t node = 0; node < variance_factors.size (); ++node)
    if (even_.nodes.base[node].x () > middle)
      variance_factors[node] = 9;
  const FineRows rows = rowsOf (even_, .3f, variance_factors);
  for (std::uint32_t node = 0; node < even_.graph->size (); ++node)
    EXPECT_EQ (sizeOfRow (even_, rows, node), even_.nodes.base[node].x () > middle ? max_row_length : fine_k);
}

TEST (UnevenNoiseTest, DensePlacesAreSmoothedAsOthersAre)
{
  constexpr double sigma = 0.4; // .8 of the dense half's spacing: too much for fine neighbourhoods there
  const Vectors points = withNoise (unevenPlane (), sigma, 5);
  SmoothingOptions options = robustOptions (false);
  options.rounds.noise = {static_cast<float> (sigma), 1};
  const Vectors smooth = sum (points, smoothed (asPositions (points), 32, options).displacements);
  double sums[2] = {0, 0};
  std::size_t counts[2] = {0, 0};
  for (const auto& point : smooth) {
    const Eigen::Vector2f place = point.head<2> () - Eigen::Vector2f (middle, middle);
    if (place.cwiseAbs ().maxCoeff () > 16 || std::abs (place.x ()) < 4) // near an edge, or at the transition
      continue;
    sums[place.x () > 0] += std::abs (point.z ());
    ++counts[place.x () > 0];
  }
  const double sparse = sums[0] / static_cast<double> (counts[0]), dense = sums[1] / static_cast<double> (counts[1]);
  EXPECT_LT (sparse, 0.16 * sigma);
  EXPECT_LT (dense, 0.16 * sigma);
}
} // namespace
