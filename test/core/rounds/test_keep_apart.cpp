// SPDX-License-Identifier: BSD-3-Clause
#include "smoothed.h"

#include <core/search/node_blocks.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
using namespace pcl_normal_smoothing::core;
using namespace test_support;

constexpr int side = 9;
constexpr std::uint32_t middle = side * side / 2, beside = middle + 1;

/** A grid of spacing 1 whose middle point moves. */
class KeepApartTest : public testing::Test
{
protected:
  KeepApartTest ()
  : points_ (planeGrid (side, 1).points)
  , start_ (points_.size (), Eigen::Vector3f::Zero ())
  , offsets_ (start_)
  , normals_ (points_.size (), Eigen::Vector3f::UnitZ ())
  {}

  /** The resulting offsets, in the order of the cloud. */
  Vectors
  keptApart ()
  {
    const auto graph = NeighborGraph::build (asPositions (points_), {12, radius_}, Execution (2));
    Positions nodes = gather (asPositions (points_), graph->order ());
    nodes.offset = byNode (offsets_, *graph);
    const Vectors normals = byNode (normals_, *graph), start = byNode (start_, *graph);
    Vectors moved (points_.size ());
    KeepApartStep step {};
    step.nodes = nodeArrays (nodes, normals);
    step.start = start.data ()->data ();
    step.oriented = oriented_;
    step.max_displacement = max_displacement_;
    step.moved = moved.data ()->data ();
    forEachBlock (*graph, Execution (2), [&] (const BlockRows& rows) { kernels ().keep_apart (step, rows); });
    return byPoint (moved, *graph);
  }

  /** The vector from the middle point to the one beside it. */
  static Eigen::Vector3f
  way (const Vectors& points, const Vectors& offsets)
  {
    return points[beside] + offsets[beside] - points[middle] - offsets[middle];
  }

  Vectors points_, start_, offsets_, normals_;
  bool oriented_ = false;
  float radius_ = std::numeric_limits<float>::infinity ();
  float max_displacement_ = std::numeric_limits<float>::infinity ();
};

TEST_F (KeepApartTest, PointsThatCameCloseShareTheWayBack)
{
  const Eigen::Vector3f toBeside = way (points_, offsets_).normalized ();
  offsets_[middle] = 0.9f * toBeside;
  const Vectors kept = keptApart ();
  EXPECT_NEAR ((kept[middle] - offsets_[middle]).dot (toBeside), -0.2f, 0.07f);
  EXPECT_NEAR ((kept[beside] - offsets_[beside]).dot (toBeside), 0.2f, 0.07f);
  EXPECT_GT (way (points_, kept).norm (), 0.4f);
}

TEST_F (KeepApartTest, OnlyAlongTheSurface)
{
  offsets_[middle] = 0.9f * way (points_, offsets_) + Eigen::Vector3f (0, 0, 0.1f);
  const Vectors kept = keptApart ();
  EXPECT_GT ((kept[middle] - offsets_[middle]).norm (), 0.1f);
  for (std::size_t i = 0; i < points_.size (); ++i)
    EXPECT_NEAR (kept[i].z (), offsets_[i].z (), 1e-6f) << "point " << i;
}

TEST_F (KeepApartTest, PointsThatWereCloseStayWhereTheyAre)
{
  points_[middle] += 0.9f * way (points_, offsets_);
  EXPECT_EQ (keptApart (), offsets_);
  for (auto& offset : offsets_) // the same if all move in one direction
    offset = start_.front () + Eigen::Vector3f (0.25f, 0.5f, 0.125f);
  EXPECT_EQ (keptApart (), offsets_);
}

TEST_F (KeepApartTest, NothingMovesBesideAnEdgeOrWithoutNormal)
{
  offsets_[middle] = 0.9f * way (points_, offsets_);
  for (const Eigen::Vector3f& normal : {Eigen::Vector3f (1, 0, 0), Eigen::Vector3f (NAN, NAN, NAN)}) {
    normals_[beside] = normal;
    const Vectors kept = keptApart ();
    EXPECT_EQ (kept[middle], offsets_[middle]);
    EXPECT_EQ (kept[beside], offsets_[beside]);
  }
}

TEST_F (KeepApartTest, OfOppositeNormalsOnlyWhereTheyMeanTheSameSide)
{
  offsets_[middle] = 0.9f * way (points_, offsets_);
  normals_[beside] *= -1;
  EXPECT_NE (keptApart ()[middle], offsets_[middle]);
  oriented_ = true;
  EXPECT_EQ (keptApart ()[middle], offsets_[middle]);
}

TEST_F (KeepApartTest, WhatLiesAboveIsInNoDirection)
{
  offsets_[middle] = way (points_, offsets_) + Eigen::Vector3f (0.001f, 0, 0.2f);
  EXPECT_EQ (keptApart ()[middle], offsets_[middle]);
}

TEST_F (KeepApartTest, RowsOfFewPointsDependOnNoOthers)
{
  radius_ = 1.1f; // only the four nearest
  offsets_[middle] = 0.9f * way (points_, offsets_);
  const Eigen::Vector3f expected = keptApart ()[middle];
  EXPECT_NE (expected, offsets_[middle]);
  for (std::size_t i = 0; i < points_.size (); ++i)
    if ((points_[i] - points_[middle]).norm () > 2.5f) // move these together: blocks with longer rows
      points_[i] = points_[0] + 0.01f * points_[i];
  EXPECT_EQ (keptApart ()[middle], expected);
}

TEST_F (KeepApartTest, NotFartherFromTheStartThanTheCap)
{
  offsets_[middle] = 0.9f * way (points_, offsets_);
  offsets_[beside] = 0.05f * way (points_, start_);
  max_displacement_ = 0.1f;
  EXPECT_LE ((keptApart ()[beside] - start_[beside]).norm (), 0.1f + 1e-6f);
}

/** The first percentile of the distances to the nearest other point. */
float
closest (const Vectors& points)
{
  const auto graph = NeighborGraph::build (asPositions (points), {2}, Execution (2));
  std::vector<float> distances;
  for (std::size_t node = 0; node < graph->size (); ++node) {
    const IndexRow row = rowInCloud (*graph, node);
    distances.push_back ((points[row[1]] - points[row[0]]).norm ());
  }
  std::sort (distances.begin (), distances.end ());
  return distances[distances.size () / 100];
}

TEST (KeepApart, SmoothedPointsDoNotClump)
{
  const Shape shapes[] = {torus (6000, 1, 0.4), sphere (6000, 1), planeGrid (75, 0.0466f)};
  for (const Shape& shape : shapes)
    for (const bool fast : {false, true})
      for (const double noise : {0.1, 0.2, 0.3}) {
        const Vectors points = withNoise (shape.points, noise * 0.046, 31);
        const Vectors result =
            sum (points, smoothed (asPositions (points), neighborsOf (fast), robustOptions (fast)).displacements);
        EXPECT_GT (closest (result), 0.8f * closest (points)) << "noise " << noise << ", fast " << fast;
      }
}
} // namespace
