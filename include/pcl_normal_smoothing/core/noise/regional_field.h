// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/positions.h>

#include <utility>

namespace pcl_normal_smoothing
{
namespace core
{
/** A number that varies slowly over a cloud, given by regions. */
struct RegionalField
{
  struct Region
  {
    /** The middle of its box, and the distance from there to the corners, > 0; in the unit of the positions. */
    Eigen::Vector3f centre;
    float reach;
    float value;
  };

  std::vector<Region> regions;

  /** A mean over all regions, in which nearer ones count more. \return \a otherwise if there are no regions, or no
    * weight is above 0 */
  float
  valueAt (const Eigen::Vector3f& place, float otherwise) const;

  std::vector<float>
  values () const;

  /** The same for positions in another unit: see Positions::unit. */
  RegionalField
  inUnit (double unit) const;
};

/** The value of such a number at one point of a sample. */
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
