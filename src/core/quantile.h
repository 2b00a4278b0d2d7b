// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

namespace pcl_normal_smoothing
{
namespace core
{
/** The value below which \a share of the values lie; 0 if there are none. \param[in] share at least 0, below 1 */
inline float
quantile (std::vector<float> values, double share)
{
  if (values.empty ())
    return 0;
  const auto at = values.begin () + static_cast<std::ptrdiff_t> (share * static_cast<double> (values.size ()));
  std::nth_element (values.begin (), at, values.end ());
  return *at;
}
} // namespace core
} // namespace pcl_normal_smoothing
