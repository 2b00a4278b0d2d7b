// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>

namespace pcl_normal_smoothing::evaluation
{

/** Random numbers, uniform in [-1, 1), the same on every machine. */
class Jitter
{
public:
  double
  operator() ()
  {
    return static_cast<double> (engine_ () >> 11) * 0x1p-52 - 1;
  }

private:
  std::mt19937_64 engine_;
};

} // namespace pcl_normal_smoothing::evaluation
