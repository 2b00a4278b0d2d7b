// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "thinned_noise.h"

#include "wide_noise.h"

namespace pcl_normal_smoothing
{
namespace core
{
/** Noise that is wide in a part of the cloud only, or varies: that of depth cameras grows with the square of the
  * distance, their spacing with the distance. \return sigma 0 if there is none */
WideNoise
wideNoiseOfPart (ThinnedNoise& cloud, const Execution& execution);
} // namespace core
} // namespace pcl_normal_smoothing
