// SPDX-License-Identifier: BSD-3-Clause
#include "surface_noise.h"

#include "mesh_measures.h"

#include <cmath>
#include <random>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
/** ln x for x > 0, in plain arithmetic: std::log may differ by a bit between machines. */
double
logarithm (double x)
{
  int exponent;
  double mantissa = std::frexp (x, &exponent); // 0.5 to 1
  if (mantissa < 0.70710678118654752) {
    mantissa *= 2;
    --exponent;
  }
  // ln m = 2 artanh s = 2 (s + s^3 / 3 + s^5 / 5 + ...), |s| < 0.172
  const double s = (mantissa - 1) / (mantissa + 1);
  double sum = 0;
  for (int n = 21; n >= 1; n -= 2)
    sum = sum * (s * s) + 1.0 / n;
  return exponent * 0.69314718055994531 + 2 * s * sum;
}

/** Random numbers that the standard defines to the bit, unlike those of std::normal_distribution. */
class Random
{
public:
  explicit Random (std::uint64_t seed) : engine_ (seed) {}

  /** Standard normal, by Marsaglia's polar method. */
  double
  normal ()
  {
    double u, square;
    do {
      u = symmetric ();
      const double v = symmetric ();
      square = u * u + v * v;
    } while (square >= 1 || square == 0);
    return u * std::sqrt (-2 * logarithm (square) / square);
  }

  /** Uniform on the unit sphere (Marsaglia 1972). */
  Eigen::Vector3d
  direction ()
  {
    double u, v, square;
    do {
      u = symmetric ();
      v = symmetric ();
      square = u * u + v * v;
    } while (square >= 1);
    const double scale = 2 * std::sqrt (1 - square);
    return {u * scale, v * scale, 1 - 2 * square};
  }

private:
  /** Uniform in [-1, 1). */
  double
  symmetric ()
  {
    return static_cast<double> (engine_ () >> 11) * 0x1p-52 - 1;
  }

  std::mt19937_64 engine_;
};
} // namespace

std::string
nameOf (NoiseType type)
{
  return type == NoiseType::GN ? "GN" : "GR";
}

std::vector<std::pair<std::string, NoiseType>>
namedNoiseTypes ()
{
  std::vector<std::pair<std::string, NoiseType>> types;
  for (const NoiseType type : {NoiseType::GN, NoiseType::GR})
    types.emplace_back (nameOf (type), type);
  return types;
}

std::vector<Eigen::Vector3d>
noisyVertices (const Mesh& mesh, NoiseType type, double sigma, std::uint64_t seed)
{
  Random random (seed);
  std::vector<Eigen::Vector3d> points = mesh.vertices;
  const std::vector<Eigen::Vector3d> normals = vertexNormals (mesh);
  for (std::size_t i = 0; i < points.size (); ++i) {
    const double length = sigma * random.normal ();
    points[i] += length * (type == NoiseType::GN ? normals[i] : random.direction ());
  }
  return points;
}
} // namespace tools
} // namespace pcl_normal_smoothing
