// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "searched.h"

#include <core/noise/layer_estimate.h>

#include <cmath>

namespace test_support
{
/** Spacing of the pixels of clouds in layers. */
inline constexpr float layer_spacing = 0.01f;

/** Noise that is constant in patches of 3 x 3 pixels, as that of disparities is. */
inline double
patchNoise (double x, double y)
{
  const auto place =
      static_cast<std::uint64_t> (std::lround (x / (3 * layer_spacing)) * 1000 + std::lround (y / (3 * layer_spacing)));
  return gaussianNoise (7, place);
}

inline pcl_normal_smoothing::core::LayerEstimate
layersOf (const Searched& cloud, unsigned threads = 2)
{
  using namespace pcl_normal_smoothing::core;
  return estimateLayers (*cloud.graph, cloud.nodes, Execution (threads));
}

/** A wall with windows, all set back by the same depth, as a pinhole camera at the origin sees it: without reveals. */
inline pcl_normal_smoothing::core::Vectors
wallWithWindows ()
{
  constexpr int side = 90;
  constexpr double wall = 1.5, recess = 0.06, tangent_of_pixel = 0.006;
  pcl_normal_smoothing::core::Vectors points;
  for (int row = -side; row < side; ++row)
    for (int column = -side; column < side; ++column) {
      const double x = tangent_of_pixel * column, y = tangent_of_pixel * row;
      const auto isWindow = [] (double place) { return std::remainder (place, 0.5) > 0; };
      const double depth = isWindow (wall * x) && isWindow (wall * y + 0.1) ? wall + recess : wall;
      points.emplace_back (static_cast<float> (depth * x), static_cast<float> (depth * y), static_cast<float> (depth));
    }
  return points;
}
/** A wavy floor, slanting away from a pinhole camera at the origin whose disparities are rounded.
  * \param[in] noise of the disparities before that, in steps, different at every pixel
  * \param[in] aside how far the cloud is then moved away from the camera */
inline pcl_normal_smoothing::core::Vectors
viewInSteps (double noise, float aside = 0)
{
  constexpr int side = 75;
  constexpr double tangent_of_pixel = 0.005, steps_at_one = 200;
  pcl_normal_smoothing::core::Vectors points;
  for (int row = -side; row < side; ++row)
    for (int column = -side; column < side; ++column) {
      const double x = tangent_of_pixel * column, y = tangent_of_pixel * row;
      const double depth = 2 / (1 + 0.7 * y) + 0.05 * std::sin (9 * x);
      const double disparity = std::round (steps_at_one / depth + noise * gaussianNoise (11, points.size ()));
      const double rounded = steps_at_one / disparity;
      points.emplace_back (static_cast<float> (rounded * x) + aside, static_cast<float> (rounded * y),
                           static_cast<float> (rounded));
    }
  return points;
}
} // namespace test_support
