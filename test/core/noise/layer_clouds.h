// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "searched.h"

#include <core/noise/layer_estimate.h>

#include <cmath>

namespace test_support
{
/** Of the pixels of clouds in layers. */
inline constexpr float layer_spacing = 0.01f;

/** Alike in patches of 3 x 3 pixels, as noise of the disparity is. */
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
} // namespace test_support
