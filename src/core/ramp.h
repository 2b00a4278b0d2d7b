// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace pcl_normal_smoothing
{
namespace core
{
/** Rises linearly with \a x from 0 at \a begin to 1 at \a begin + \a width, constant outside. \param[in] width above
  * 0 */
template <typename Number>
Number
ramp (Number x, Number begin, Number width)
{
  return std::clamp ((x - begin) / width, Number (0), Number (1));
}
} // namespace core
} // namespace pcl_normal_smoothing
