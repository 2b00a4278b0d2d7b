// SPDX-License-Identifier: BSD-3-Clause
#include "smoothed.h"

#include <pcl_normal_smoothing/core/error.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace pcl_normal_smoothing;
using namespace test_support;

core::SmoothingOptions
updateOnly (UpdateRule rule, int iterations)
{
  core::SmoothingOptions options;
  options.normals = NormalSource::INPUT;
  options.filter.iterations = 0;
  options.update.rule = rule;
  options.update.iterations = iterations;
  return options;
}

core::SmoothingOptions
wholeMethod (UpdateRule rule)
{
  core::SmoothingOptions options;
  options.normals = NormalSource::WPCA;
  options.filter.iterations = 2;
  options.update.rule = rule;
  options.update.sigma_s = rule == UpdateRule::PAPER ? 1.0f / 3 : 0.03f;
  options.update.iterations = 10;
  return options;
}

double
meanRadius (const Vectors& points)
{
  double sum = 0;
  for (const auto& point : points)
    sum += point.cast<double> ().norm ();
  return sum / static_cast<double> (points.size ());
}

Vectors
opposite (Vectors normals)
{
  for (auto& normal : normals)
    normal = -normal;
  return normals;
}

/** Root mean square of the distances to a torus. */
double
distanceToTorus (const Vectors& points, double major, double minor)
{
  double sum_sq = 0;
  for (const auto& point : points) {
    const double from_axis = std::hypot (point.x (), point.y ());
    sum_sq += std::pow (std::hypot (from_axis - major, point.z ()) - minor, 2);
  }
  return std::sqrt (sum_sq / static_cast<double> (points.size ()));
}

TEST (Plane, StaysWithEveryMethod)
{
  const Vectors plane = planeGrid (15, 0.1f).points;
  for (const NormalSource source : {NormalSource::PCA, NormalSource::WPCA, NormalSource::HOUGH})
    for (const NormalWeight weight : {NormalWeight::THRESHOLD, NormalWeight::GAUSSIAN, NormalWeight::MIXED})
      for (const UpdateRule rule : {UpdateRule::PAPER, UpdateRule::COMPENSATED}) {
        core::SmoothingOptions options = wholeMethod (rule);
        options.normals = source;
        options.filter.weight = weight;
        for (const auto& displacement : smoothed (asPositions (plane), 9, options).displacements)
          ASSERT_LT (displacement.norm (), 1e-6) << displacement.transpose ();
      }
}

TEST (Sphere, TheCompensatedUpdateDoesNotDriftAndThePapersDoes)
{
  for (const double radius : {0.01, 1.0, 700.0}) {
    const Shape shape = sphere (2000, radius);
    for (const Vectors& normals : {shape.normals, opposite (shape.normals)}) {
      const auto drift = [&] (UpdateRule rule) {
        const Smoothed result = smoothed (asPositions (shape.points), 15, updateOnly (rule, 20), normals);
        return meanRadius (sum (shape.points, result.displacements)) / radius - 1;
      };
      EXPECT_LT (std::abs (drift (UpdateRule::COMPENSATED)), 1e-4) << "radius " << radius;
      EXPECT_GT (drift (UpdateRule::PAPER), 0.01) << "radius " << radius; // outward, whichever way the normals point
    }
  }
}

TEST (Cylinder, TheCompensatedUpdateDoesNotDrift)
{
  const Shape shape = cylinder (60, 60, 1, 6);
  const Smoothed result =
      smoothed (asPositions (shape.points), 15, updateOnly (UpdateRule::COMPENSATED, 20), shape.normals);
  for (std::size_t i = 0; i < shape.size (); ++i) {
    const Eigen::Vector3f point = shape.points[i] + result.displacements[i];
    EXPECT_NEAR (std::hypot (point.x (), point.y ()), 1, 1e-4) << "point " << i;
  }
}

TEST (Torus, NoiseGoesAndThePapersUpdateDriftsAway)
{
  const double noise = 0.01;
  const Vectors noisy = withNoise (torus (5000, 1, 0.4).points, noise, 80);
  const auto after = [&] (UpdateRule rule) {
    return distanceToTorus (sum (noisy, smoothed (asPositions (noisy), 15, wholeMethod (rule)).displacements), 1, 0.4);
  };
  const double before = distanceToTorus (noisy, 1, 0.4);
  EXPECT_NEAR (before, noise, 0.1 * noise);
  EXPECT_LT (after (UpdateRule::COMPENSATED), 0.6 * before);
  EXPECT_GT (after (UpdateRule::PAPER), before);
}

TEST (Cube, EdgesStaySharp)
{
  const Shape shape = cube (25, 1);
  const double noise = 0.004;
  const Vectors noisy = withNoise (shape.points, noise, 81);
  core::SmoothingOptions options = updateOnly (UpdateRule::COMPENSATED, 10);
  const Smoothed result = smoothed (asPositions (noisy), 15, options, shape.normals);
  const Vectors smooth = sum (noisy, result.displacements);
  double before = 0, after = 0;
  for (std::size_t i = 0; i < shape.size (); ++i) {
    before += std::pow (shape.normals[i].dot (noisy[i] - shape.points[i]), 2);
    after += std::pow (shape.normals[i].dot (smooth[i] - shape.points[i]), 2);
    EXPECT_LT (std::abs (shape.normals[i].dot (smooth[i] - shape.points[i])), 4 * noise) << "point " << i;
  }
  EXPECT_LT (after, 0.25 * before);
}

TEST (ParallelSheets, OrientedNormalsKeepThemApart)
{
  const float gap = 0.05f; // half the spacing: most neighbours are on the other sheet
  const Shape sheets = parallelSheets (20, 0.1f, gap);
  const std::size_t count = sheets.size () / 2;
  const auto gap_after = [&] (UpdateRule rule, bool oriented) {
    core::SmoothingOptions options = updateOnly (rule, 5);
    options.filter.iterations = 3;
    options.filter.oriented = options.update.oriented = oriented;
    const Smoothed result = smoothed (asPositions (withNoise (sheets.points, 0.002, 82)), 12, options, sheets.normals);
    double distance = 0;
    for (std::size_t i = 0; i < count; ++i) {
      distance += gap + (result.displacements[count + i] - result.displacements[i]).z ();
      EXPECT_TRUE (!oriented || result.normals[i].z () < -0.999) << "the normal of point " << i;
    }
    return distance / static_cast<double> (count);
  };
  for (const UpdateRule rule : {UpdateRule::PAPER, UpdateRule::COMPENSATED}) {
    EXPECT_NEAR (gap_after (rule, true), gap, 0.02 * gap);
    EXPECT_LT (gap_after (rule, false), 0.5 * gap); // the failure of the paper's Fig. 10
  }
}

TEST (Smoothing, SaysWhereNoPointHasANormal)
{
  Vectors line;
  for (int i = 0; i < 30; ++i)
    line.push_back (static_cast<float> (i) * Eigen::Vector3f (1, 2, 0));
  for (const NormalSource source : {NormalSource::PCA, NormalSource::WPCA, NormalSource::HOUGH}) {
    core::SmoothingOptions options = wholeMethod (UpdateRule::COMPENSATED);
    options.normals = source;
    EXPECT_THROW (smoothed (asPositions (line), 7, options), core::Error);
    EXPECT_THROW (smoothed (asPositions (Vectors (9, line[1])), 7, options), core::Error);
  }
}
} // namespace
