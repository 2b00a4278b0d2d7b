// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "thinned_noise.h"

#include "wide_noise.h"

namespace pcl_normal_smoothing
{
namespace core
{
/** Where the noise is wide in a part of the cloud only, or differs from place to place: that of depth cameras grows as
  * the square of the distance, the spacing as the distance. \return sigma 0 where it is so nowhere */
WideNoise
wideNoiseOfPart (ThinnedNoise& cloud, const Execution& execution);
} // namespace core
} // namespace pcl_normal_smoothing
