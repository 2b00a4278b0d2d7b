// SPDX-License-Identifier: BSD-3-Clause
#include "noise/wide_clouds.h"

#include <core/noise/cloud_thickness.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace
{
using namespace pcl_normal_smoothing::core;
using namespace test_support;

double
thicknessOf (const Vectors& points)
{
  return cloudThickness (asPositions (points), Execution (2));
}

TEST (CloudThicknessTest, GrowsWithTheNoise)
{
  EXPECT_NEAR (thicknessOf (square (0)), 0, 1e-6);
  const double little = thicknessOf (bumpySphere (0.5)), more = thicknessOf (bumpySphere (2)),
               much = thicknessOf (bumpySphere (3));
  EXPECT_LT (little, 0.05);
  EXPECT_GT (more, little + 0.05);
  EXPECT_GT (much, more + 0.05);
  EXPECT_LT (much, 0.45);
}

TEST (CloudThicknessTest, OfVolumesIsLarge)
{
  for (const std::uint64_t count : {2000, 5000, 20000})
    EXPECT_GT (thicknessOf (leaves (count)), 0.5) << count;
  Vectors ball = leaves (20000);
  ball.erase (std::remove_if (ball.begin (), ball.end (),
                              [] (const Eigen::Vector3f& p) {
                                return (p - Eigen::Vector3f::Constant (.5f)).norm () > .5f;
                              }),
              ball.end ());
  EXPECT_GT (thicknessOf (ball), 0.5);
}

TEST (CloudThicknessTest, DoesNotDependOnTheOrder)
{
  const Vectors points = bumpySphere (2);
  EXPECT_EQ (thicknessOf (Vectors (points.rbegin (), points.rend ())), thicknessOf (points));
}

TEST (CloudThicknessTest, OfFewPlacesIsUnknown)
{
  EXPECT_EQ (thicknessOf (leaves (1000)), std::numeric_limits<double>::infinity ());
}
} // namespace
