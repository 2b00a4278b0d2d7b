// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/parallel_for.h>
#include <pcl_normal_smoothing/core/positions.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** Thickness of a cloud: the ratio of the smallest to the middle variance, as the median over parts of 1/64 of the
  * cloud, and of 1/32; the smaller of the two. For a surface it grows with the noise, and is below .45 for noise up to
  * .08 of the cloud's size; volumes, such as leaves and grass, have .5 to .9. Uses a sample of 4,096 places.
  * \return infinity if the sample is too small */
double
cloudThickness (const Positions& nodes, const Execution& execution);
} // namespace core
} // namespace pcl_normal_smoothing
