// SPDX-License-Identifier: BSD-3-Clause
#define PCL_NORMAL_SMOOTHING_ISA lanes_of_the_test
#include <core/kernels/lanes.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
using namespace pcl_normal_smoothing::core::lanes_of_the_test;

float
expOfMinusOne (float x)
{
  return expOfMinus (splat (x))[0];
}

TEST (Exponential, AgreesWithTheLibrarys)
{
  double worst = 0; // relative error over 1 + x / 2, as rounding the exponent adds an error proportional to x
  for (int i = 0; i < 870000; ++i) {
    const float x = static_cast<float> (i) * 1e-4f;
    const double expected = std::exp (-static_cast<double> (x));
    worst = std::max (worst, std::abs (expOfMinusOne (x) - expected) / (expected * (1 + .5 * x)));
  }
  EXPECT_LT (worst, 2e-7);
}

TEST (Exponential, IsOneAtZeroAndNeverAbove)
{
  EXPECT_EQ (expOfMinusOne (0), 1);
  EXPECT_EQ (expOfMinusOne (-0.0f), 1);
  for (float x = 1e-38f; x < 1e-2f; x *= 3)
    EXPECT_LE (expOfMinusOne (x), 1) << x;
}

TEST (Exponential, IsZeroFromEightyEightOn)
{
  EXPECT_GT (expOfMinusOne (87.0f), 0);
  for (const float x : {88.0f, 89.0f, 1e10f, 3e38f, std::numeric_limits<float>::infinity ()})
    EXPECT_EQ (expOfMinusOne (x), 0) << x;
}

TEST (Exponential, IsNanForNan)
{
  EXPECT_TRUE (std::isnan (expOfMinusOne (std::numeric_limits<float>::quiet_NaN ())));
}

TEST (Exponential, EveryLaneIsItsOwn)
{
  Lanes x {};
  for (int lane = 0; lane < lane_count; ++lane)
    x[lane] = 0.37f * static_cast<float> (lane);
  const Lanes result = expOfMinus (x);
  for (int lane = 0; lane < lane_count; ++lane)
    EXPECT_EQ (result[lane], expOfMinusOne (x[lane])) << "lane " << lane;
}
} // namespace
