// SPDX-License-Identifier: BSD-3-Clause
#include "graph_rows.h"
#include "oracle.h"

#include <pcl_normal_smoothing/core/chain/normal_filter.h>
#include <pcl_normal_smoothing/core/error.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
using namespace pcl_normal_smoothing::core;
using namespace test_support;
using pcl_normal_smoothing::MixedThreshold;
using pcl_normal_smoothing::NormalWeight;

constexpr float nan_float = std::numeric_limits<float>::quiet_NaN ();

Vectors
filteredByPoint (const Vectors& cloud, const Vectors& normals, std::uint32_t k, const NormalFilterOptions& options)
{
  const Positions positions = asPositions (cloud);
  const auto graph = NeighborGraph::build (positions, {k}, Execution (2));
  Vectors of_nodes = byNode (normals, *graph);
  filterNormals (*graph, gather (positions, graph->order ()), options, Execution (2), of_nodes);
  return byPoint (of_nodes, *graph);
}

Vectors
normalized (Vectors vectors)
{
  for (auto& vector : vectors)
    vector.normalize ();
  return vectors;
}

struct FilterCase
{
  std::string name;
  NormalWeight weight;
  MixedThreshold mixed_threshold;
  bool oriented;
  float sigma_s = 0.3f;
};

void
PrintTo (const FilterCase& test, std::ostream* out)
{
  *out << test.name;
}

class NormalFilterTest : public testing::TestWithParam<FilterCase>
{
protected:
  static NormalFilterOptions
  options (int iterations)
  {
    NormalFilterOptions result;
    result.weight = GetParam ().weight;
    result.mixed_threshold = GetParam ().mixed_threshold;
    result.oriented = GetParam ().oriented;
    result.sigma_s = GetParam ().sigma_s;
    result.iterations = iterations;
    return result;
  }

  const Shape shape_ = torus (1200, 1, 0.4);
  const Vectors cloud_ = withNoise (shape_.points, 0.02, 50);
  // Noisy normals with random signs, even when the options say that they are oriented.
  const Vectors normals_ = withRandomSigns (normalized (withNoise (shape_.normals, 0.2, 51)), 52);
};

TEST_P (NormalFilterTest, AgreesWithTheOracle)
{
  const Points points = inDouble (cloud_);
  for (const std::size_t k : {7, 15})
    for (const int iterations : {1, 5}) {
      const Vectors result = filteredByPoint (cloud_, normals_, std::uint32_t (k), options (iterations));
      const Points expected = oracleFilter (points, nearestRows (points, k), inDouble (normals_), options (iterations));
      for (std::size_t i = 0; i < points.size (); ++i) {
        ASSERT_LT (lineAngleDegrees (result[i].cast<double> (), expected[i]), 0.05)
            << "point " << i << ", k " << k << ", iterations " << iterations;
        ASSERT_GT (result[i].dot (expected[i].cast<float> ()), 0) << "the sign of point " << i;
        ASSERT_NEAR (result[i].norm (), 1, 1e-6);
      }
    }
}

TEST_P (NormalFilterTest, KeepsTheSignOfEveryNormal)
{
  const Vectors clean = GetParam ().oriented ? shape_.normals : withRandomSigns (shape_.normals, 53);
  const Vectors result = filteredByPoint (shape_.points, clean, 10, options (4));
  for (std::size_t i = 0; i < clean.size (); ++i)
    EXPECT_GT (result[i].dot (clean[i]), 0.8) << "point " << i;
}

TEST_P (NormalFilterTest, NoIterationLeavesTheNormals)
{
  EXPECT_EQ (filteredByPoint (cloud_, normals_, 7, options (0)), normals_);
}

TEST_P (NormalFilterTest, NormalsOfAPlaneStay)
{
  const Shape plane = planeGrid (12, 0.1f);
  EXPECT_EQ (filteredByPoint (plane.points, plane.normals, 9, options (5)), plane.normals);
}

TEST_P (NormalFilterTest, AMissingNormalStaysMissingAndDoesNotCount)
{
  Vectors normals = GetParam ().oriented ? shape_.normals : withRandomSigns (shape_.normals, 54);
  for (std::size_t i = 0; i < normals.size (); i += 5)
    normals[i].setConstant (nan_float);
  const Vectors result = filteredByPoint (shape_.points, normals, 10, options (3));
  std::size_t filtered = 0;
  for (std::size_t i = 0; i < normals.size (); ++i) {
    EXPECT_EQ (std::isnan (result[i].x ()), i % 5 == 0) << "point " << i;
    EXPECT_TRUE (i % 5 == 0 || result[i].dot (normals[i]) > 0.7) << "point " << i;
    if (i % 5 != 0 && result[i] != normals[i])
      ++filtered;
  }
  EXPECT_GT (filtered, normals.size () / 2) << "beside missing ones, normals are filtered as well";
}

TEST_P (NormalFilterTest, SurvivesPointsThatAreAllEqual)
{
  const Vectors equal (20, Eigen::Vector3f (1, 2, 3));
  Vectors normals;
  for (int i = 0; i < 20; ++i)
    normals.push_back (Eigen::Vector3f (0.1f * static_cast<float> (i % 3), 0, 1).normalized ());
  for (const auto& normal : filteredByPoint (equal, normals, 7, options (3))) {
    EXPECT_NEAR (normal.norm (), 1, 1e-6);
    EXPECT_GT (normal.z (), 0.9);
  }
}

INSTANTIATE_TEST_SUITE_P (
    Weights,
    NormalFilterTest,
    testing::Values (FilterCase {"threshold", NormalWeight::THRESHOLD, MixedThreshold::PRINTED, false},
                     FilterCase {"threshold_oriented", NormalWeight::THRESHOLD, MixedThreshold::PRINTED, true},
                     FilterCase {"gaussian", NormalWeight::GAUSSIAN, MixedThreshold::PRINTED, false},
                     FilterCase {"gaussian_wide", NormalWeight::GAUSSIAN, MixedThreshold::PRINTED, false, 0.6f},
                     FilterCase {"gaussian_oriented", NormalWeight::GAUSSIAN, MixedThreshold::PRINTED, true},
                     FilterCase {"mixed_printed", NormalWeight::MIXED, MixedThreshold::PRINTED, false},
                     FilterCase {"mixed_rms", NormalWeight::MIXED, MixedThreshold::RMS, false},
                     FilterCase {"mixed_rms_oriented", NormalWeight::MIXED, MixedThreshold::RMS, true}),
    [] (const auto& test) { return test.param.name; });

TEST (NormalFilter, BringsNoisyNormalsCloserToTheTruth)
{
  const Shape shape = sphere (2000, 1);
  const Vectors noisy = normalized (withNoise (shape.normals, 0.15, 55));
  NormalFilterOptions options;
  options.iterations = 3;
  const Vectors filtered = filteredByPoint (shape.points, noisy, 12, options);
  double before = 0, after = 0;
  for (std::size_t i = 0; i < shape.size (); ++i) {
    before += lineAngleDegrees (noisy[i].cast<double> (), shape.normals[i].cast<double> ());
    after += lineAngleDegrees (filtered[i].cast<double> (), shape.normals[i].cast<double> ());
  }
  EXPECT_LT (after, 0.4 * before);
}

TEST (NormalFilter, RefusesOptionsOutOfRange)
{
  const auto refused = [] (auto set, const std::string& value) {
    NormalFilterOptions options;
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
  refused ([] (auto& options) { options.sigma_s = -0.25f; }, "-0.25");
  refused ([] (auto& options) { options.sigma_s = 0; }, "is 0:");
  refused ([] (auto& options) { options.sigma_s = nan_float; }, "nan");
  refused ([] (auto& options) { options.threshold = 1; }, "is 1:");
  refused ([] (auto& options) { options.threshold = -0.5f; }, "-0.5");
  refused ([] (auto& options) { options.threshold = nan_float; }, "nan");
  EXPECT_NO_THROW (check (NormalFilterOptions ()));
}
} // namespace
