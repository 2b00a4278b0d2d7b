// SPDX-License-Identifier: BSD-3-Clause
#include "shapes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace test_support
{
namespace
{
constexpr double pi = 3.14159265358979323846;

void
add (Shape& shape, const Eigen::Vector3d& point, const Eigen::Vector3d& normal)
{
  shape.points.push_back (point.cast<float> ());
  shape.normals.push_back (normal.cast<float> ());
}

std::uint64_t
hash (std::uint64_t seed, std::uint64_t index)
{
  std::uint64_t z = (seed + 1) * 0x9E3779B97F4A7C15u + index * 0xD1B54A32D192ED03u;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}
} // namespace

Shape
planeGrid (int side, float spacing)
{
  Shape shape;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      add (shape, Eigen::Vector3d (x, y, 0) * double (spacing), Eigen::Vector3d::UnitZ ());
  return shape;
}

Shape
groovedPlate (double pitch)
{
  constexpr int count = 10000;
  constexpr double width = 4, plastic = 1.324717957244746; // of a groove; 2D analogue of the golden ratio
  const double length = pitch + 2;                         // of paper from one groove to the next
  const double side = length * std::round (std::sqrt (count) / length);
  Shape shape;
  for (int i = 1; i <= count; ++i) {
    const double u = side * std::fmod (.5 + i / plastic, 1),
                 v = count / side * std::fmod (.5 + i / plastic / plastic, 1);
    const double along = std::fmod (u, length), behind = std::max (0., along - width - 1);
    const double x = std::min (along, width) + std::min (behind, pitch - width) + pitch * std::floor (u / length);
    const double z = std::clamp (along - width, 0., 1.) - std::max (0., along - pitch - 1);
    const bool is_wall = (along > width && along < width + 1) || along > pitch + 1;
    add (shape, {x, v, z}, is_wall ? Eigen::Vector3d::UnitX () : Eigen::Vector3d::UnitZ ());
  }
  return shape;
}

Shape
sphere (int count, double radius)
{
  Shape shape;
  const double golden_angle = pi * (3 - std::sqrt (5.0));
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count, r = std::sqrt (1 - z * z), angle = golden_angle * i;
    const Eigen::Vector3d normal (r * std::cos (angle), r * std::sin (angle), z);
    add (shape, radius * normal, normal);
  }
  return shape;
}

Shape
cylinder (int around, int along, double radius, double height)
{
  Shape shape;
  for (int row = 0; row < along; ++row)
    for (int i = 0; i < around; ++i) {
      // Every other row is turned by half a step, so that no neighbourhood is a regular grid.
      const double angle = 2 * pi * (i + 0.5 * (row % 2)) / around;
      const Eigen::Vector3d normal (std::cos (angle), std::sin (angle), 0);
      add (shape, radius * normal + Eigen::Vector3d (0, 0, height * row / (along - 1)), normal);
    }
  return shape;
}

Shape
cube (int side, double edge)
{
  Shape shape;
  for (int axis = 0; axis < 3; ++axis)
    for (const double far : {0.0, 1.0})
      for (int a = 0; a < side; ++a)
        for (int b = 0; b < side; ++b) {
          Eigen::Vector3d point, normal = Eigen::Vector3d::Zero ();
          point[axis] = far * edge;
          point[(axis + 1) % 3] = edge * (a + 0.5) / side;
          point[(axis + 2) % 3] = edge * (b + 0.5) / side;
          normal[axis] = 2 * far - 1;
          add (shape, point, normal);
        }
  return shape;
}

Shape
torus (int count, double major, double minor)
{
  Shape shape;
  for (std::uint64_t i = 0; shape.points.size () < static_cast<std::size_t> (count); ++i) {
    const double u = 2 * pi * uniformNoise (90, i), v = 2 * pi * uniformNoise (91, i);
    const double from_axis = major + minor * std::cos (v);
    if (uniformNoise (92, i) * (major + minor) > from_axis) // the inner side has less area
      continue;
    const Eigen::Vector3d normal (std::cos (v) * std::cos (u), std::cos (v) * std::sin (u), std::sin (v));
    add (shape, minor * normal + major * Eigen::Vector3d (std::cos (u), std::sin (u), 0), normal);
  }
  return shape;
}

Shape
parallelSheets (int side, float spacing, float gap)
{
  Shape shape = planeGrid (side, spacing);
  const std::size_t count = shape.size ();
  for (std::size_t i = 0; i < count; ++i) {
    shape.normals[i] = -Eigen::Vector3f::UnitZ ();
    shape.points.push_back (shape.points[i] + Eigen::Vector3f (0, 0, gap));
    shape.normals.push_back (Eigen::Vector3f::UnitZ ());
  }
  return shape;
}

double
uniformNoise (std::uint64_t seed, std::uint64_t index)
{
  return static_cast<double> (hash (seed, index) >> 11) / 9007199254740992.0; // 2^53
}

double
gaussianNoise (std::uint64_t seed, std::uint64_t index)
{
  double sum = -6;
  for (std::uint64_t i = 0; i < 12; ++i)
    sum += uniformNoise (seed, 12 * index + i);
  return sum;
}

Vectors
withNoise (const Vectors& points, double sigma, std::uint64_t seed)
{
  Vectors noisy = points;
  for (std::size_t i = 0; i < points.size (); ++i)
    for (int d = 0; d < 3; ++d)
      noisy[i][d] = static_cast<float> (points[i][d] + sigma * gaussianNoise (seed, 3 * i + std::uint64_t (d)));
  return noisy;
}

Vectors
withNormalNoise (const Shape& shape, double sigma, std::uint64_t seed)
{
  return withNormalNoise (
      shape, [=] (const Eigen::Vector3f&) { return sigma; }, seed);
}

Vectors
withNormalNoise (const Shape& shape, const std::function<double (const Eigen::Vector3f&)>& sigma, std::uint64_t seed)
{
  Vectors points = shape.points;
  for (std::size_t i = 0; i < points.size (); ++i)
    points[i] += static_cast<float> (sigma (points[i]) * gaussianNoise (seed, i)) * shape.normals[i];
  return points;
}

Vectors
withRandomSigns (Vectors vectors, std::uint64_t seed)
{
  for (std::size_t i = 0; i < vectors.size (); ++i)
    if (uniformNoise (seed, i) < 0.5)
      vectors[i] = -vectors[i];
  return vectors;
}

std::vector<std::uint32_t>
permutation (std::size_t size, std::uint64_t seed)
{
  std::vector<std::uint32_t> order (size);
  std::iota (order.begin (), order.end (), 0u);
  std::sort (order.begin (), order.end (),
             [seed] (std::uint32_t a, std::uint32_t b) { return hash (seed, a) < hash (seed, b); });
  return order;
}

Vectors
shuffled (const Vectors& points, std::uint64_t seed)
{
  Vectors result;
  for (const std::uint32_t i : permutation (points.size (), seed))
    result.push_back (points[i]);
  return result;
}

Positions
asPositions (const Vectors& points)
{
  return {points, Vectors (points.size (), Eigen::Vector3f::Zero ())};
}

double
diagonal (const Vectors& points)
{
  Eigen::AlignedBox3f box;
  for (const auto& point : points)
    box.extend (point);
  return box.diagonal ().norm ();
}

double
lineAngleDegrees (const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  // The cross product resolves small angles; an arc cosine in double does not.
  return std::atan2 (a.cross (b).norm (), std::abs (a.dot (b))) * 180 / pi;
}
} // namespace test_support
