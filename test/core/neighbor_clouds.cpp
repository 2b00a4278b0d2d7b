// SPDX-License-Identifier: BSD-3-Clause
#include "neighbor_clouds.h"

#include <algorithm>
#include <cmath>

namespace test_support
{
namespace
{
Vectors
uniformCube (std::size_t count, std::uint64_t seed)
{
  Vectors points;
  for (std::size_t i = 0; i < count; ++i)
    points.emplace_back (static_cast<float> (uniformNoise (seed, 3 * i)),
                         static_cast<float> (uniformNoise (seed, 3 * i + 1)),
                         static_cast<float> (uniformNoise (seed, 3 * i + 2)));
  return points;
}

Vectors
clustered ()
{
  Vectors points = uniformCube (500, 2);
  for (std::size_t i = 0; i < points.size (); ++i)
    points[i] = 100 * points[i % 5] + (i % 3 == 0 ? 0.001f : 1.0f) * points[i];
  return points;
}

Vectors
integerGrid ()
{
  Vectors points;
  for (const std::uint32_t i : permutation (512, 3)) // so that the order of indices differs from that of positions
    points.emplace_back (static_cast<float> (i % 8), static_cast<float> (i / 8 % 8), static_cast<float> (i / 64));
  return points;
}

Vectors
scaledAndMoved (Vectors points, const Eigen::Vector3f& scale, const Eigen::Vector3f& to)
{
  for (auto& point : points)
    point = point.cwiseProduct (scale) + to;
  return points;
}

/** Distances whose squares underflow in float, or keep only a few digits. */
Vectors
vanishingSquares ()
{
  Vectors points = uniformCube (500, 9);
  for (std::size_t i = 0; i < points.size (); ++i)
    points[i] *= std::ldexp (1.0f, -60 - static_cast<int> (i % 16));
  return points;
}

Vectors
duplicated ()
{
  const Vectors few = uniformCube (40, 4);
  Vectors points;
  for (std::size_t i = 0; i < 400; ++i)
    points.push_back (few[i * 7 % few.size ()]);
  return points;
}

void
addDouble (const Eigen::Vector3d& place, Positions& positions)
{
  positions.base.push_back (place.cast<float> ());
  positions.offset.push_back ((place - positions.base.back ().cast<double> ()).cast<float> ());
}

/** Doubles at UTM coordinates: floats are 0.5 apart there, so the shape is in the offsets. */
Positions
doubles ()
{
  Positions positions;
  for (const auto& point : uniformCube (500, 5))
    addDouble (point.cast<double> () + Eigen::Vector3d (4.5e5, 5e6, 120), positions);
  return positions;
}

/** Clusters so far apart that floats relative to the middle one cannot distinguish the points within the others. */
Positions
doublesFarFromEachOther ()
{
  Positions positions;
  const Vectors shape = uniformCube (500, 10);
  for (std::size_t i = 0; i < shape.size (); ++i)
    addDouble (0.3 * shape[i].cast<double> () + Eigen::Vector3d (1e6, -2e6, 3e6) * (static_cast<double> (i % 5) - 2),
               positions);
  return positions;
}
} // namespace

std::vector<NamedCloud>
hardClouds ()
{
  const Vectors cube = uniformCube (500, 1);
  const Eigen::Vector3f zero (0, 0, 0), far (5e6f, -3e6f, 2e6f);
  Vectors many_equal (50, Eigen::Vector3f (1, 2, 3));
  return {{"uniform", asPositions (cube)},
          {"clustered", asPositions (clustered ())},
          {"planar", asPositions (scaledAndMoved (cube, {1, 1, 0}, zero))},
          {"collinear", asPositions (scaledAndMoved (cube, {1, 0, 0}, zero))},
          {"duplicated", asPositions (duplicated ())},
          {"all_equal", asPositions (many_equal)},
          {"integer_grid", asPositions (integerGrid ())},
          {"far", asPositions (scaledAndMoved (cube, {200, 200, 200}, far))},
          {"doubles", doubles ()},
          {"doubles_far_from_each_other", doublesFarFromEachOther ()},
          {"vanishing_squares", asPositions (vanishingSquares ())},
          {"seventeen", asPositions (uniformCube (17, 6))},
          {"three", asPositions (uniformCube (3, 7))},
          {"one", asPositions (uniformCube (1, 8))}};
}

float
squaredDistance (const Positions& cloud, std::uint32_t i, std::uint32_t j)
{
  const Eigen::Vector3f d = cloud.difference (i, j);
  return (d.x () * d.x () + d.y () * d.y ()) + d.z () * d.z ();
}

IndexRow
bruteForceRow (const Positions& cloud, std::uint32_t point, const pcl_normal_smoothing::core::NeighborQuery& query)
{
  std::vector<std::pair<float, std::uint32_t>> others;
  for (std::uint32_t j = 0; j < cloud.size (); ++j) {
    const float sq_dist = squaredDistance (cloud, point, j);
    if (j != point && sq_dist < query.radius * query.radius)
      others.emplace_back (sq_dist, j);
  }
  std::sort (others.begin (), others.end ());
  if (query.k > 0)
    others.resize (std::min<std::size_t> (others.size (), query.k - 1));
  IndexRow row {point};
  for (const auto& other : others)
    row.push_back (other.second);
  return row;
}
} // namespace test_support
