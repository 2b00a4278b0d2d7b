// SPDX-License-Identifier: BSD-3-Clause
#include "searched.h"

#include <core/noise/quadric_projection.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace pcl_normal_smoothing::core;
using namespace test_support;

constexpr int count = 10000;

/** A saddle over the unit square, with noise in spacings. */
Vectors
saddle (double noise)
{
  Vectors points;
  for (std::uint64_t i = 0; i < count; ++i) {
    const double x = uniformNoise (1, i), y = uniformNoise (2, i);
    points.push_back (
        Eigen::Vector3d (x, y, x * x - y * y + noise / std::sqrt (count) * gaussianNoise (3, i)).cast<float> ());
  }
  return points;
}

RegionalField
everywhere (float ratio)
{
  return {{{Eigen::Vector3f (.5f, .5f, 0), 1, ratio}}};
}

Vectors
projected (const Vectors& points, const RegionalField& ratios, unsigned threads = 2)
{
  Searched cloud (points);
  projectOntoQuadrics (*cloud.graph, ratios, Execution (threads), cloud.nodes);
  Vectors moved (points.size ());
  for (std::size_t node = 0; node < cloud.nodes.size (); ++node)
    moved[cloud.graph->order ()[node]] = cloud.nodes.inCloudUnit (node);
  return moved;
}

/** Mean distance to the saddle along z. */
double
meanOffset (const Vectors& points)
{
  double sum = 0;
  for (const Eigen::Vector3f& p : points)
    sum += std::abs (p.z () - (p.x () * p.x () - p.y () * p.y ()));
  return sum / static_cast<double> (points.size ());
}

TEST (QuadricProjectionTest, LittleOfTheNoiseIsLeft)
{
  for (const double noise : {1, 2, 3, 5}) { // from 3 on, it takes more than one projection
    const Vectors points = saddle (noise);
    const double left = meanOffset (projected (points, everywhere (static_cast<float> (noise)))) / meanOffset (points);
    EXPECT_LT (left, noise > 2 ? 0.23 : 0.4) << noise;
  }
}

TEST (QuadricProjectionTest, TheSurfaceStays)
{
  EXPECT_LT (meanOffset (projected (saddle (0), everywhere (2))), 2e-4);
}

TEST (QuadricProjectionTest, WhereNoiseIsNotWideNodesStay)
{
  const Vectors points = saddle (1);
  EXPECT_EQ (projected (points, everywhere (0.7f)), points);
  const RegionalField halves {{{Eigen::Vector3f (0, .5f, 0), .1f, 0.1f}, {Eigen::Vector3f (1, .5f, 0), .1f, 2.0f}}};
  const Vectors moved = projected (points, halves);
  for (std::size_t i = 0; i < points.size (); ++i)
    if (points[i].x () < 0.1f) {
      ASSERT_EQ (moved[i], points[i]);
    }
  EXPECT_LT (meanOffset (moved), 0.8 * meanOffset (points));
}

TEST (QuadricProjectionTest, MoreNeighboursAndMorePassesForMoreNoise)
{
  const Vectors points = saddle (3);
  double last = meanOffset (points);
  for (const float ratio : {1.0f, 1.9f, 3.0f}) {
    const double left = meanOffset (projected (points, everywhere (ratio)));
    EXPECT_LT (left, 0.8 * last) << ratio;
    last = left;
  }
}

TEST (QuadricProjectionTest, ThreadsDoNotMatter)
{
  const Vectors points = saddle (2);
  EXPECT_EQ (projected (points, everywhere (2), 1), projected (points, everywhere (2), 3));
}

TEST (QuadricProjectionTest, FewPointsStayFinite)
{
  for (const std::size_t size : {1, 2, 6, 7, 40}) {
    Vectors points = saddle (2);
    points.resize (size);
    for (const Eigen::Vector3f& point : projected (points, everywhere (2)))
      EXPECT_TRUE (point.allFinite ()) << size;
  }
}
} // namespace
