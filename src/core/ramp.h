// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace pcl_normal_smoothing
{
namespace core
{
/** How far \a x is on the way from \a begin to \a begin + \a width: 0 before it, 1 beyond. \param[in] width above 0 */
template <typename Number>
Number
ramp (Number x, Number begin, Number width)
{
  return std::clamp ((x - begin) / width, Number (0), Number (1));
}
} // namespace core
} // namespace pcl_normal_smoothing
