// SPDX-License-Identifier: BSD-3-Clause
#include "clouds.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace pcl_normal_smoothing::benchmarks
{
namespace
{
constexpr double minor_radius = 0.4;
} // namespace

double
spacingOf (std::size_t size)
{
  return std::sqrt (4 * M_PI * M_PI * minor_radius / static_cast<double> (size));
}

Cloud::Ptr
makeTorus (std::size_t size, Order order)
{
  std::mt19937_64 random (1);
  std::uniform_real_distribution<double> angle (0, 2 * M_PI);
  std::normal_distribution<double> noise (0, 0.2 * spacingOf (size));
  std::vector<double> rings (size);
  std::generate (rings.begin (), rings.end (), [&] { return angle (random); });
  if (order == Order::ALONG_RINGS)
    std::sort (rings.begin (), rings.end ());
  auto cloud = pcl::make_shared<Cloud> ();
  cloud->reserve (size);
  for (const double u : rings) {
    const double v = angle (random), r = minor_radius + noise (random);
    cloud->emplace_back (static_cast<float> ((1 + r * std::cos (v)) * std::cos (u)),
                         static_cast<float> ((1 + r * std::cos (v)) * std::sin (u)),
                         static_cast<float> (r * std::sin (v)));
  }
  return cloud;
}

double
meanDistance (const Cloud& cloud)
{
  double sum = 0;
  for (const auto& p : cloud)
    sum += std::abs (std::hypot (std::hypot (p.x, p.y) - 1.0, static_cast<double> (p.z)) - minor_radius);
  return sum / static_cast<double> (cloud.size ());
}
} // namespace pcl_normal_smoothing::benchmarks
