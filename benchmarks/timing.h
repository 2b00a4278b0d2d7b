// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

namespace pcl_normal_smoothing::benchmarks
{
template <typename Run>
double
seconds (const Run& run)
{
  const auto start = std::chrono::steady_clock::now ();
  run ();
  return std::chrono::duration<double> (std::chrono::steady_clock::now () - start).count ();
}

inline double
median (std::vector<double> values)
{
  std::sort (values.begin (), values.end ());
  return values[values.size () / 2];
}
} // namespace pcl_normal_smoothing::benchmarks
