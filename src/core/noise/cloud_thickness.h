// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/parallel_for.h>
#include <pcl_normal_smoothing/core/positions.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** How thick a cloud is: the smallest variance of a part over its middle one, as the median over parts of 1/64 of the
  * cloud, and of 1/32; the smaller of the two. A surface has the less the less noise it has, below .45 where that is as
  * much as .08 of the cloud's size; volumes, as leaves and grass are, have .5 to .9. Looks at a sample of 4,096 places.
  * \return infinity where there are too few of them to tell */
double
cloudThickness (const Positions& nodes, const Execution& execution);
} // namespace core
} // namespace pcl_normal_smoothing
