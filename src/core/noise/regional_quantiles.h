// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/noise/regional_field.h>

#include <utility>

namespace pcl_normal_smoothing
{
namespace core
{
/** A number that varies slowly over a cloud, at one point of a sample. */
struct LocalValue
{
  Eigen::Vector3f place;
  float value;
};

/** Minimum number of sample points in a region for a quantile of the noise within a tenth. */
constexpr std::size_t usual_region_size = 64;

/** A quantile of a sample in each of its regions.
  * \param[in] sample at least one point, in any order
  * \param[in] spacing between neighbouring points, > 0
  * \param[in] level in [0, 1), .5 for the median
  * \param[in] region_size minimum number of sample points in a region, which has fewer than twice as many; a smaller
  * sample is one region */
RegionalField
regionalQuantiles (std::vector<LocalValue> sample,
                   float spacing,
                   double level,
                   std::size_t region_size = usual_region_size);

inline RegionalField
regionalMedians (std::vector<LocalValue> sample, float spacing, std::size_t region_size = usual_region_size)
{
  return regionalQuantiles (std::move (sample), spacing, .5, region_size);
}
} // namespace core
} // namespace pcl_normal_smoothing
