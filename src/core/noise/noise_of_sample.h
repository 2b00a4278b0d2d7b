// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "neighborhood_widening.h"
#include "noise_sample.h"

#include <pcl_normal_smoothing/core/noise/noise_estimate.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** The estimate from a sample of the whole cloud, as if its neighbourhoods needed no widening; empty if most of its
  * rows are short. */
NoiseEstimate
noiseOfSample (const NoiseSample& sample);

/** The estimate from the sample of a thinned cloud. Clumps are not sought, as detail looks like them there. */
NoiseEstimate
noiseOfThinnedSample (const NoiseSample& sample);

/** The same for widened neighbourhoods. In layers, sigma is at least what steps of their size cause, and varies as
  * the steps do. On lines, only neighbourhoods of 12 and 16 points count, as 8 may still lie on one line. */
NoiseEstimate
noiseOfSample (const NoiseSample& sample, const Widening& widening);
} // namespace core
} // namespace pcl_normal_smoothing
