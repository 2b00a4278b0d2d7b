// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shapes.h"

#include <cmath>

namespace test_support
{
/** A room of 12 x 8 x 3 m with a ball of radius 0.7 m, seen by a scanner 1.6 m above the floor. */
struct ScannedRoom
{
  /** Elevations from -limit to limit and azimuths all around, in degrees; noise along the rays, in metres. */
  ScannedRoom (double limit, double elevation_step, double azimuth_step, double noise)
  {
    std::uint64_t number = 0;
    for (double elevation = -limit; elevation <= limit; elevation += elevation_step)
      for (double azimuth = 0; azimuth < 360; azimuth += azimuth_step) {
        const double e = elevation * M_PI / 180, a = azimuth * M_PI / 180;
        const Eigen::Vector3d ray (std::cos (e) * std::cos (a), std::cos (e) * std::sin (a), std::sin (e));
        const double range = rangeOf (ray) + noise * gaussianNoise (11, number++);
        points.push_back ((range * ray).cast<float> ());
      }
  }

  /** Distance from a point to the surface. */
  static double
  distance (const Eigen::Vector3d& p)
  {
    const Eigen::Vector3d to_walls = (p - high).cwiseAbs ().cwiseMin ((p - low).cwiseAbs ());
    return std::min (to_walls.minCoeff (), std::abs ((p - ball).norm () - radius));
  }

  /** Root mean square of these distances. */
  static double
  error (const Vectors& points)
  {
    double sum = 0;
    for (const auto& p : points)
      sum += std::pow (distance (p.cast<double> ()), 2);
    return std::sqrt (sum / static_cast<double> (points.size ()));
  }

  Vectors points;

private:
  double
  rangeOf (const Eigen::Vector3d& ray) const
  {
    const Eigen::Vector3d walls = high.cwiseQuotient (ray).cwiseMax (low.cwiseQuotient (ray));
    const double along = ray.dot (ball), discriminant = along * along - ball.squaredNorm () + radius * radius;
    return along > 0 && discriminant > 0 ? along - std::sqrt (discriminant) : walls.minCoeff ();
  }

  static inline const Eigen::Vector3d low {-4, -5, -1.6}, high {8, 3, 1.4}, ball {2.5, 1.5, -.9};
  static constexpr double radius = .7;
};
} // namespace test_support
