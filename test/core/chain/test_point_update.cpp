// SPDX-License-Identifier: BSD-3-Clause
#include "graph_rows.h"
#include "oracle.h"

#include <pcl_normal_smoothing/core/chain/point_update.h>
#include <pcl_normal_smoothing/core/error.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
using namespace pcl_normal_smoothing::core;
using namespace test_support;
using pcl_normal_smoothing::UpdateRule;

constexpr float nan_float = std::numeric_limits<float>::quiet_NaN ();

/** Displacements by point, in the order of the cloud. */
Vectors
displacementsByPoint (const Vectors& cloud, const Vectors& normals, std::uint32_t k, const PointUpdateOptions& options)
{
  const Positions positions = asPositions (cloud);
  const NeighborQuery query {k};
  const auto graph = NeighborGraph::build (positions, query, Execution (2));
  Positions nodes = gather (positions, graph->order ());
  const SearchAgain search_again = [&] (const Positions& moved) {
    return graph->rebuild (moved, query, Execution (2));
  };
  updatePoints (graph, byNode (normals, *graph), options, search_again, Execution (2), nodes);
  return byPoint (nodes.offset, *graph);
}

struct UpdateCase
{
  std::string name;
  UpdateRule rule;
  float sigma_s;
  bool oriented;
};

void
PrintTo (const UpdateCase& test, std::ostream* out)
{
  *out << test.name;
}

class PointUpdateTest : public testing::TestWithParam<UpdateCase>
{
protected:
  static PointUpdateOptions
  options (int iterations)
  {
    PointUpdateOptions result;
    result.rule = GetParam ().rule;
    result.sigma_s = GetParam ().sigma_s;
    result.oriented = GetParam ().oriented;
    result.iterations = iterations;
    return result;
  }

  const Shape shape_ = torus (1200, 1, 0.4);
  const Vectors cloud_ = withNoise (shape_.points, 0.02, 60);
  const Vectors normals_ = GetParam ().oriented ? shape_.normals : withRandomSigns (shape_.normals, 61);
};

TEST_P (PointUpdateTest, AgreesWithTheOracle)
{
  const Points points = inDouble (cloud_);
  const double tolerance = 1e-5 * diagonal (cloud_);
  for (const std::size_t k : {7, 15})
    for (const int iterations : {1, 2, 7}) {
      const Vectors result = displacementsByPoint (cloud_, normals_, std::uint32_t (k), options (iterations));
      const Points expected = oracleUpdate (points, nearestRows (points, k), inDouble (normals_), options (iterations));
      for (std::size_t i = 0; i < points.size (); ++i)
        ASSERT_LT ((points[i] + result[i].cast<double> () - expected[i]).norm (), tolerance)
            << "point " << i << ", k " << k << ", iterations " << iterations;
    }
}

TEST_P (PointUpdateTest, IsBlindToTheSignsUnlessTheyAreKnown)
{
  const Vectors once = displacementsByPoint (cloud_, normals_, 9, options (3));
  const Vectors turned = displacementsByPoint (cloud_, withRandomSigns (normals_, 62), 9, options (3));
  EXPECT_EQ (once == turned, !GetParam ().oriented);
}

TEST_P (PointUpdateTest, APlaneStays)
{
  const Shape plane = planeGrid (12, 0.1f);
  for (const auto& displacement : displacementsByPoint (plane.points, plane.normals, 9, options (10)))
    EXPECT_TRUE (displacement.isZero (0)) << displacement.transpose ();
}

TEST_P (PointUpdateTest, NoPointGoesFartherThanTheMaximum)
{
  PointUpdateOptions limited = options (6);
  limited.max_displacement = 0.005f;
  const Vectors free = displacementsByPoint (cloud_, normals_, 9, options (6));
  std::size_t farther = 0, at_limit = 0;
  for (const auto& displacement : free)
    farther += displacement.norm () > limited.max_displacement;
  for (const auto& displacement : displacementsByPoint (cloud_, normals_, 9, limited)) {
    EXPECT_LE (displacement.norm (), limited.max_displacement * 1.000001f);
    at_limit += displacement.norm () > limited.max_displacement * 0.999f;
  }
  EXPECT_GT (farther, 100u);
  EXPECT_GT (at_limit, 50u) << "points must reach the limit, not stay";
  limited.max_displacement = 1e9f;
  EXPECT_EQ (displacementsByPoint (cloud_, normals_, 9, limited), free);
}

TEST_P (PointUpdateTest, SearchingAnewFollowsThePoints)
{
  PointUpdateOptions searching = options (4);
  const Vectors without = displacementsByPoint (cloud_, normals_, 9, searching);
  searching.search_interval = 4; // a search after the last iteration would have no effect
  EXPECT_EQ (displacementsByPoint (cloud_, normals_, 9, searching), without);
  searching.search_interval = 2;
  const Vectors result = displacementsByPoint (cloud_, normals_, 9, searching);
  EXPECT_NE (result, without);

  // Two runs of two iterations in double, each with the neighbours found at its start.
  Points expected = inDouble (cloud_);
  for (int run = 0; run < 2; ++run)
    expected = oracleUpdate (expected, nearestRows (expected, 9), inDouble (normals_), options (2));
  for (std::size_t i = 0; i < cloud_.size (); ++i)
    EXPECT_LT ((cloud_[i].cast<double> () + result[i].cast<double> () - expected[i]).norm (), 1e-5 * diagonal (cloud_));
}

TEST_P (PointUpdateTest, APointWithoutANormalStaysAndTheOthersMove)
{
  Vectors normals = normals_;
  for (std::size_t i = 0; i < normals.size (); i += 5)
    normals[i].setConstant (nan_float);
  const Vectors result = displacementsByPoint (cloud_, normals, 9, options (2));
  for (std::size_t i = 0; i < normals.size (); ++i)
    EXPECT_TRUE (i % 5 == 0 ? result[i].isZero (0) : result[i].allFinite () && !result[i].isZero (0)) << "point " << i;
}

TEST_P (PointUpdateTest, PointsThatAreAllEqualStay)
{
  const Vectors equal (20, Eigen::Vector3f (1, 2, 3)), up (20, Eigen::Vector3f::UnitZ ());
  for (const auto& displacement : displacementsByPoint (equal, up, 7, options (3)))
    EXPECT_TRUE (displacement.isZero (0)) << displacement.transpose ();
}

INSTANTIATE_TEST_SUITE_P (Rules,
                          PointUpdateTest,
                          testing::Values (UpdateCase {"paper", UpdateRule::PAPER, 1.0f / 3, false},
                                           UpdateCase {"paper_oriented", UpdateRule::PAPER, 1.0f / 3, true},
                                           UpdateCase {"compensated", UpdateRule::COMPENSATED, 0.03f, false},
                                           UpdateCase {"compensated_wide", UpdateRule::COMPENSATED, 1.0f / 3, false},
                                           UpdateCase {"compensated_oriented", UpdateRule::COMPENSATED, 0.03f, true}),
                          [] (const auto& test) { return test.param.name; });

TEST (PointUpdate, RefusesOptionsOutOfRange)
{
  const auto refused = [] (auto set, const std::string& value) {
    PointUpdateOptions options;
    set (options);
    try {
      check (options);
      FAIL () << value << " was accepted";
    }
    catch (const Error& error) {
      EXPECT_NE (std::string (error.what ()).find (value), std::string::npos) << error.what ();
    }
  };
  refused ([] (auto& options) { options.iterations = -3; }, "-3");
  refused ([] (auto& options) { options.search_interval = -2; }, "-2");
  for (const auto& [value, name] :
       {std::pair (-0.25f, "-0.25"), std::pair (0.0f, "is 0:"), std::pair (nan_float, "nan")}) {
    refused ([v = value] (auto& options) { options.sigma_s = v; }, name);
    refused ([v = value] (auto& options) { options.max_displacement = v; }, name);
  }
  EXPECT_NO_THROW (check (PointUpdateOptions ()));
}
} // namespace
