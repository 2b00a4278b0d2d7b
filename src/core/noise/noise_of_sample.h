// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "neighborhood_widening.h"
#include "noise_sample.h"

#include <pcl_normal_smoothing/core/noise/noise_estimate.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** The estimate from the sample of the whole cloud, as if its neighbourhoods needed no widening; nothing where most of
  * its rows are short. */
NoiseEstimate
estimateNoise (const NoiseSample& sample);

/** The same where neighbourhoods were widened. In layers: at least what steps of their size make of a surface, and it
  * varies as the steps do. On lines: by neighbourhoods of twelve and sixteen points, for eight may still lie on one. */
NoiseEstimate
estimateNoise (const NoiseSample& sample, const Widening& widening);
} // namespace core
} // namespace pcl_normal_smoothing
