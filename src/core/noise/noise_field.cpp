// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/noise/noise_field.h>

#include <algorithm>

namespace pcl_normal_smoothing
{
namespace core
{
float
NoiseField::smallestFactor () const
{
  const std::vector<float> values = factors.values ();
  return isEven () ? 1 : *std::min_element (values.begin (), values.end ());
}

float
NoiseField::largestFactor () const
{
  const std::vector<float> values = factors.values ();
  return isEven () ? 1 : *std::max_element (values.begin (), values.end ());
}

Numbers
varianceFactors (const NoiseField& field, const Positions& positions, const Execution& execution)
{
  Numbers factors;
  if (field.isEven ())
    return factors;
  factors.resize (positions.size ());
  parallelFor (positions.size (), execution.silent (), [&] (std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const float factor = field.factorAt (positions.base[i]);
      factors[i] = factor * factor;
    }
  });
  return factors;
}
} // namespace core
} // namespace pcl_normal_smoothing
