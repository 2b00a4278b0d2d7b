// SPDX-License-Identifier: BSD-3-Clause
#include "shapes.h"

#include <core/noise/residual_quantiles.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace pcl_normal_smoothing::core;
using namespace test_support;

/** Simulated residual variances of quadrics on noise of variance 1, multiplied by a factor per neighbourhood size, and
  * by \a relief at all but a fifth of the places. */
ResidualVariances
variances (const std::array<double, 3>& factors, double relief = 1)
{
  constexpr std::array<int, 3> degrees {2, 6, 10};
  constexpr std::uint64_t count = 4000;
  ResidualVariances result;
  for (std::size_t size = 0; size < 3; ++size)
    for (std::uint64_t i = 0; i < count; ++i) {
      double sum = 0;
      for (int degree = 0; degree < degrees[size]; ++degree)
        sum += std::pow (gaussianNoise (100 * size + degree, i), 2);
      const double of_place = i % 5 == 0 ? 1 : relief;
      result[size].push_back (static_cast<float> (factors[size] * of_place * sum / degrees[size]));
    }
  return result;
}

TEST (ResidualQuantilesTest, WhereEightTellNothingMoreDo)
{
  const double sigma = sigmaInClumps (variances ({0.3, 1, 1.2}), 0.3);
  EXPECT_GT (sigma, 0.8);
  EXPECT_LT (sigma, 1.1);
}

TEST (ResidualQuantilesTest, WhereCoordinatesComeInStepsEightTellNothing)
{
  for (const double of_8 : {0., 1e-6, .01}) {
    const double sigma = sigmaBy (variances ({of_8, 1, 1.3}), 0);
    EXPECT_GT (sigma, 0.85) << of_8;
    EXPECT_LT (sigma, 1.2) << of_8;
  }
}

TEST (ResidualQuantilesTest, LargerNeighbourhoodsShowHowTheNoiseVariesUnlessThereIsDetail)
{
  EXPECT_EQ (sizeForField (variances ({1, 1, 1})), of_12) << "noise";
  EXPECT_EQ (sizeForField (variances ({.5, 1, 1})), of_12) << "scan lines";
  EXPECT_EQ (sizeForField (variances ({1, 1.1, 1.3})), of_8) << "detail";
  EXPECT_EQ (sizeForField (variances ({.01, 1, 1.3})), of_12) << "coordinates in steps";
  EXPECT_EQ (sizeForField (variances ({0, 0, 0})), of_12) << "nothing";
}

TEST (ResidualQuantilesTest, WhatIsNotClumpedStaysAsItIsRead)
{
  EXPECT_EQ (sigmaInClumps (variances ({0.8, 1, 1.1}), 0.3), 0.3) << "noise";
  EXPECT_EQ (sigmaInClumps (variances ({0.3, 1, 3}), 0.3), 0.3) << "detail";
  EXPECT_EQ (sigmaInClumps (variances ({0.01, 1, 1.1}), 0.3), 0.3) << "coordinates in steps";
  EXPECT_EQ (sigmaInClumps (variances ({0.3, 1, 1.2}, 20), 0.3), 0.3) << "relief";
  EXPECT_EQ (sigmaInClumps (variances ({0.3, 1, 1.2}), 1.5), 1.5) << "more is read already";
  EXPECT_EQ (sigmaInClumps (variances ({0, 0, 0}), 0), 0) << "nothing";
}
} // namespace
