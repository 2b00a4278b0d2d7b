// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "searched.h"

#include <core/noise/wide_noise.h>

#include <cmath>

namespace test_support
{
inline constexpr int wide_count = 20000;
inline const double wide_spacing = 1 / std::sqrt (wide_count);

/** A square, randomly sampled; noise in spacings. */
inline Vectors
square (double noise)
{
  Vectors points;
  for (std::uint64_t i = 0; i < wide_count; ++i)
    points.push_back (
        Eigen::Vector3d (uniformNoise (1, i), uniformNoise (2, i), noise * wide_spacing * gaussianNoise (3, i))
            .cast<float> ());
  return points;
}

/** A square in crossing sweeps: points are closer to others of their sweep than to those of another. */
inline Vectors
crossingSweeps (double noise)
{
  constexpr std::uint64_t sweeps = 160, points_of_each = 300;
  Vectors points;
  for (std::uint64_t i = 0; i < sweeps * points_of_each; ++i) {
    const std::uint64_t sweep = i / points_of_each;
    const double direction = 2 * M_PI * uniformNoise (4, sweep);
    const double way = static_cast<double> (i % points_of_each) / points_of_each - .5;
    const Eigen::Vector3d point (uniformNoise (5, sweep) + way * std::cos (direction),
                                 uniformNoise (6, sweep) + way * std::sin (direction), noise * gaussianNoise (7, i));
    if (point.head<2> ().minCoeff () > 0 && point.head<2> ().maxCoeff () < 1)
      points.push_back (point.cast<float> ());
  }
  return points;
}

/** Eight superimposed frames of a camera, one length unit per pixel, with noise along the rays.
  * \param[in] gap every other frame sees another sheet, this far behind */
inline Vectors
framesOfAStillCamera (double noise, double gap)
{
  constexpr std::uint64_t side = 50, frames = 8;
  constexpr double jitter = 0.1;
  Vectors points;
  for (std::uint64_t i = 0; i < side * side * frames; ++i) {
    const std::uint64_t pixel = i / frames;
    const double behind = gap * static_cast<double> (i % 2);
    points.push_back (Eigen::Vector3d (static_cast<double> (pixel % side) + jitter * gaussianNoise (8, i),
                                       static_cast<double> (pixel / side) + jitter * gaussianNoise (9, i),
                                       behind + noise * gaussianNoise (7, i))
                          .cast<float> ());
  }
  return points;
}

/** A disc of steep bumps and pits, with a wavelength of eight spacings. */
inline Vectors
pits (double noise)
{
  constexpr double width = 0.1, depth = 0.03;
  Vectors points;
  for (std::uint64_t i = 0; i < wide_count; ++i) {
    const double away = std::sqrt (uniformNoise (1, i)), angle = 2 * M_PI * uniformNoise (2, i);
    const double x = away * std::cos (angle), y = away * std::sin (angle);
    const double z = depth * std::sin (2 * M_PI * x / width) * std::sin (2 * M_PI * y / width);
    points.push_back (Eigen::Vector3d (x, y, z + noise * wide_spacing * gaussianNoise (3, i)).cast<float> ());
  }
  return points;
}

/** Points throughout a cube: no surface. */
inline Vectors
leaves (std::uint64_t count)
{
  Vectors points;
  for (std::uint64_t i = 0; i < count; ++i)
    points.push_back (Eigen::Vector3d (uniformNoise (1, i), uniformNoise (2, i), uniformNoise (3, i)).cast<float> ());
  return points;
}

/** A depth camera's view of two walls: of its 240 x 240 pixels, three quarters see one at a distance of \a near, and a
  * quarter one at \a far. */
inline Vectors
twoWalls (double near, double far)
{
  constexpr int size = 240;
  Vectors points;
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column) {
      const double z = column < 3 * size / 4 ? near : far, pixel = 1.1 / size;
      points.push_back (
          Eigen::Vector3d (z * pixel * (column - size / 2), z * pixel * (row - size / 2), z).cast<float> ());
    }
  return points;
}

/** Adds a depth camera's noise along the rays: it grows as the square of the distance; \a sigma at a distance of 1. */
inline Vectors
withNoiseOfDepth (Vectors points, double sigma)
{
  for (std::size_t i = 0; i < points.size (); ++i) {
    const double z = points[i].z ();
    points[i] *= static_cast<float> (1 + sigma * z * gaussianNoise (8, i));
  }
  return points;
}

/** Mean distance to the plane z = 0. */
inline double
meanDistance (const Vectors& points)
{
  double sum = 0;
  for (const auto& p : points)
    sum += std::abs (p.z ());
  return sum / static_cast<double> (points.size ());
}

/** Distance of the surface of a bumpy sphere from its centre. */
inline double
heightOfBumps (const Eigen::Vector3d& direction)
{
  return 1 + 0.05 * std::sin (8 * direction.x ()) * std::sin (8 * direction.y ()) * std::sin (8 * direction.z ());
}

/** A bumpy sphere, randomly sampled, with isotropic noise in spacings. */
inline Vectors
bumpySphere (double noise)
{
  const double spacing_of_sphere = std::sqrt (4 * M_PI / wide_count);
  Vectors points;
  for (std::uint64_t i = 0; i < wide_count; ++i) {
    const double z = 2 * uniformNoise (1, i) - 1, angle = 2 * M_PI * uniformNoise (2, i),
                 in_plane = std::sqrt (1 - z * z);
    const Eigen::Vector3d direction (in_plane * std::cos (angle), in_plane * std::sin (angle), z);
    points.push_back ((heightOfBumps (direction) * direction).cast<float> ());
  }
  return withNoise (points, noise * spacing_of_sphere, 3);
}

inline pcl_normal_smoothing::core::WideNoise
wideNoiseOf (const Vectors& points, unsigned threads = 2)
{
  const Searched cloud (points);
  return estimateWideNoise (*cloud.graph, cloud.nodes, pcl_normal_smoothing::core::Execution (threads));
}
} // namespace test_support
