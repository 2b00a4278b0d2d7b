// SPDX-License-Identifier: BSD-3-Clause
#include "lop.h"
#include "peer_fixture.h"

#include <cmath>

namespace pcl_normal_smoothing::evaluation
{
namespace
{
double
theta (double r, double h)
{
  return std::exp (-r * r / std::pow (h / 4, 2));
}

/** The projection for points on a line, written independently from the paper. */
std::vector<double>
projectOnLine (const std::vector<double>& points, const LopParameters& parameters)
{
  const double h = parameters.h;
  std::vector<double> now = points;
  for (int k = 0; k < parameters.iterations; ++k) {
    std::vector<double> next;
    for (std::size_t i = 0; i < now.size (); ++i) {
      double attraction = 0, alphas = 0, repulsion = 0, betas = 0;
      for (const double point : points) {
        const double r = std::abs (now[i] - point), alpha = k == 0 ? theta (r, h) : theta (r, h) / r;
        attraction += alpha * point;
        alphas += alpha;
      }
      for (std::size_t j = 0; j < now.size (); ++j)
        if (const double r = std::abs (now[i] - now[j]); j != i) {
          const double beta = theta (r, h) / r * std::pow (r, -4);
          repulsion += beta * (now[i] - now[j]);
          betas += beta;
        }
      next.push_back (attraction / alphas + (k == 0 ? 0 : parameters.mu * repulsion / betas));
    }
    now = next;
  }
  return now;
}

Points
alongX (const std::vector<double>& values)
{
  Points points;
  for (const double value : values)
    points.emplace_back (value, 0, 0);
  return points;
}

TEST (Lop, FirstIterationOfTwoPointsByHand)
{
  // h = 4 makes theta (1) = 1/e: each point moves 1/e / (1 + 1/e) = 1 / (1 + e) of the way to the other.
  const Points result = locallyOptimalProjection (alongX ({0, 1}), {4, 0.25, 1});
  EXPECT_NEAR (1 / (1 + M_E), result[0].x (), 1e-12);
  EXPECT_NEAR (1 - 1 / (1 + M_E), result[1].x (), 1e-12);
}

TEST (Lop, SecondIterationOfTwoPointsByHand)
{
  // Starting from a = 1 / (1 + e): the weight towards its original position is theta (a) / a = 3.458838, towards the
  // other theta (1 - a) / (1 - a) = 0.801567. So the attraction is (0.585993 - 0.930224) / 4.260405 = -0.080798, and
  // the repulsion is 0.25 (2a - 1) = -0.115529.
  const Points result = locallyOptimalProjection (alongX ({0, 1}), {4, 0.25, 2});
  EXPECT_NEAR (0.268941 - 0.080798 - 0.115529, result[0].x (), 3e-6);
}

TEST (Lop, UnevenPointsOnALine)
{
  const std::vector<double> line {0, 1, 2.5, 3.25, 3.5};
  for (int iterations = 0; iterations <= 3; ++iterations) {
    const LopParameters parameters {20, 0.3, iterations};
    const auto expected = projectOnLine (line, parameters);
    const Points result = locallyOptimalProjection (alongX (line), parameters);
    for (std::size_t i = 0; i < line.size (); ++i)
      EXPECT_NEAR (expected[i], result[i].x (), 1e-9) << "point " << i << ", iterations " << iterations;
  }
}

TEST (Lop, RepulsionOpposesAttraction)
{
  const double without = locallyOptimalProjection (alongX ({0, 1}), {4, 0, 2})[0].x ();
  const double with = locallyOptimalProjection (alongX ({0, 1}), {4, 0.4, 2})[0].x ();
  EXPECT_GT (without, with);
}

TEST (Lop, PlaneStaysAPlane)
{
  Points plane;
  for (int i = 0; i < 100; ++i)
    plane.emplace_back (i % 10, i / 10 + 0.1 * (i % 3), 7);
  for (const auto& point : locallyOptimalProjection (plane, {3, 0.3, 5}))
    EXPECT_NEAR (7, point.z (), 1e-12);
}

TEST (Lop, PointsWithoutNeighborsAndDuplicatesStayFinite)
{
  const Points points {{0, 0, 0}, {0, 0, 0}, {100, 0, 0}};
  const Points result = locallyOptimalProjection (points, {4, 0.3, 5});
  for (std::size_t i = 0; i < points.size (); ++i)
    EXPECT_EQ (points[i], result[i]);
}

} // namespace
} // namespace pcl_normal_smoothing::evaluation
