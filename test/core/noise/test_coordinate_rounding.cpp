// SPDX-License-Identifier: BSD-3-Clause
#include "searched.h"
#include "smoothed.h"

#include <core/noise/coordinate_rounding.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

namespace
{
using namespace pcl_normal_smoothing::core;
using namespace test_support;

/** Rounds every coordinate to a multiple of \a step, and keeps one point per position. */
Vectors
rounded (const Vectors& points, float step)
{
  std::set<std::array<float, 3>> places;
  for (const auto& p : points)
    places.insert (
        {step * std::round (p.x () / step), step * std::round (p.y () / step), step * std::round (p.z () / step)});
  Vectors result;
  for (const auto& place : places)
    result.emplace_back (place[0], place[1], place[2]);
  return result;
}

std::vector<Eigen::Vector3d>
placesOf (const Vectors& points)
{
  std::vector<Eigen::Vector3d> places;
  for (std::size_t i = 0; i < points.size (); i += 1 + points.size () / 500)
    places.push_back (points[i].cast<double> ());
  return places;
}

/** The mean distance to the unit sphere. */
double
errorOf (const Vectors& points)
{
  double sum = 0;
  for (const auto& p : points)
    sum += std::abs (p.cast<double> ().norm () - 1);
  return sum / static_cast<double> (points.size ());
}

TEST (CoordinateRoundingTest, ReadsTheStep)
{
  for (const float step : {0.05f, 0.01f, 0.003f})
    EXPECT_NEAR (coordinateStep (placesOf (rounded (sphere (20000, 1).points, step))), step, 1e-3 * step);
  Vectors far = rounded (sphere (20000, 1).points, 0.0625f);
  for (auto& p : far)
    p += Eigen::Vector3f (400, -70, 30);
  EXPECT_NEAR (coordinateStep (placesOf (far)), 0.0625, 1e-4);
}

TEST (CoordinateRoundingTest, ThereIsNoneWhereOneAxisHasNone)
{
  EXPECT_EQ (coordinateStep (placesOf (sphere (5000, 1).points)), 0);
  Vectors heights = planeGrid (80, 0.01f).points; // above a grid
  for (std::size_t i = 0; i < heights.size (); ++i)
    heights[i].z () = static_cast<float> (gaussianNoise (3, i));
  EXPECT_EQ (coordinateStep (placesOf (heights)), 0);
  for (std::size_t i = 0; i < heights.size (); ++i) // terraces
    heights[i].z () = i % 3 == 0 ? 1 : i % 3 == 1 ? 2 : 3.5f;
  EXPECT_EQ (coordinateStep (placesOf (heights)), 0);
  EXPECT_EQ (coordinateStep ({}), 0);
  EXPECT_EQ (coordinateStep (placesOf (Vectors (600, Eigen::Vector3f (1, 2, 3)))), 0);
}

TEST (CoordinateRoundingTest, CentresOfVoxelsBecomeASurface)
{
  for (const float voxel : {0.04f, 0.02f, 0.011f})
    for (const bool fast : {false, true}) {
      const Vectors points = rounded (sphere (200000, 1).points, voxel);
      const Smoothed result = smoothed (asPositions (points), neighborsOf (fast), wideningOptions (fast));
      EXPECT_LT (errorOf (sum (points, result.displacements)), 0.5 * errorOf (points)) << voxel << ", fast " << fast;
    }
}

/** Mean distance to the faces of a box, except near its edges. */
double
errorOnFaces (const Vectors& points, const Vectors& places, float edge)
{
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < points.size (); ++i) {
    const Eigen::Array3f to_face = places[i].array ().abs ().min ((places[i].array () - edge).abs ());
    Eigen::Index axis;
    const float nearest = to_face.minCoeff (&axis);
    if ((to_face > 4).count () < 2 || nearest > 2)
      continue;
    const float place = points[i][axis];
    sum += std::min (std::abs (place), std::abs (place - edge));
    ++count;
  }
  return sum / count;
}

TEST (CoordinateRoundingTest, ThickShellsOfVoxelsAreNoSheets)
{
  constexpr float edge = 50.5f; // not at the centres of voxels
  const Shape box = cube (200, edge);
  Vectors points = box.points;
  for (std::size_t i = 0; i < points.size (); ++i)
    points[i] += (0.25f + 0.5f * static_cast<float> (gaussianNoise (8, i))) * box.normals[i];
  points = rounded (points, 1);
  const Smoothed result = smoothed (asPositions (points), 32, wideningOptions (false));
  EXPECT_LT (errorOnFaces (sum (points, result.displacements), points, edge),
             0.6 * errorOnFaces (points, points, edge));
}

/** A box whose top may slope: most of it shows no noise. */
Vectors
wedge (double slope)
{
  Vectors points;
  const Vectors face = planeGrid (161, 0.25f).points;
  for (const Eigen::Vector3f& p : face) {
    const auto top = static_cast<float> (20 + slope * p.x ());
    points.emplace_back (p.x (), p.y (), 0.0f);
    points.emplace_back (p.x (), p.y (), top);
    for (const float side : {0.0f, 40.0f}) {
      if (p.y () <= top)
        points.emplace_back (p.x (), side, p.y ());
      if (p.y () <= 20 + slope * side)
        points.emplace_back (side, p.x (), p.y ());
    }
  }
  return rounded (points, 1);
}

TEST (CoordinateRoundingTest, FlatPartsAStepApartAreSeen)
{
  for (const double slope : {0.0, 0.05, 0.1}) {
    const Searched cloud (wedge (slope));
    const CoordinateRounding rounding = estimateRounding (*cloud.graph, cloud.nodes, Execution (2));
    EXPECT_NEAR (rounding.step, 1, 1e-6);
    EXPECT_EQ (rounding.is_seen, slope > 0) << slope;
  }
}

TEST (CoordinateRoundingTest, CleanShapesOnALatticeStay)
{
  Vectors box; // the faces, edges included
  const Vectors face = planeGrid (41, 1).points;
  for (const Eigen::Vector3f& p : face)
    for (const float height : {0.0f, 40.0f})
      for (const auto& place : {Eigen::Vector3f (p.x (), p.y (), height), Eigen::Vector3f (p.x (), height, p.y ()),
                                Eigen::Vector3f (height, p.x (), p.y ())})
        box.push_back (place);
  for (const Vectors& points : {rounded (box, 1), planeGrid (60, 1).points}) {
    ASSERT_NEAR (coordinateStep (placesOf (points)), 1, 1e-6);
    const Smoothed result = smoothed (asPositions (points), 32, wideningOptions (false));
    for (const auto& displacement : result.displacements)
      ASSERT_LT (displacement.norm (), 1e-3f);
  }
}

TEST (CoordinateRoundingTest, NoNoiseIsNotMadeSome)
{
  const CoordinateRounding rounding {0.1f, false}, seen {0.1f, true}, none;
  EXPECT_EQ (rounding.atLeast (0.0001f), 0.0001f);
  EXPECT_FLOAT_EQ (rounding.atLeast (0.01f), 0.04f);
  EXPECT_EQ (rounding.atLeast (0.2f), 0.2f);
  EXPECT_FLOAT_EQ (seen.atLeast (0), 0.04f);
  EXPECT_EQ (none.atLeast (0.3f), 0.3f);
}

TEST (CoordinateRoundingTest, HidesTheNoise)
{
  EXPECT_EQ (noiseHiddenBy (rounded (sphere (200000, 1).points, 0.02f)), NoiseHiddenBy::ROUNDING);
  EXPECT_EQ (noiseHiddenBy (rounded (sphere (8000, 1).points, 1e-5f)), NoiseHiddenBy::NOTHING);
}
} // namespace
