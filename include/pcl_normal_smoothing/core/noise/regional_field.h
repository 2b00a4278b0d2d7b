// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/positions.h>

#include <utility>

namespace pcl_normal_smoothing
{
namespace core
{
/** A number that varies slowly over a cloud, known by regions. */
struct RegionalField
{
  struct Region
  {
    /** The middle of its box, and the distance from there to the corners, > 0: in the unit of the positions. */
    Eigen::Vector3f centre;
    float reach;
    float value;
  };

  std::vector<Region> regions;

  /** A mean of all regions, the nearer ones counting for more. \return \a otherwise without regions, or where no weight
    * is above 0 */
  float
  valueAt (const Eigen::Vector3f& place, float otherwise) const;

  std::vector<float>
  values () const;

  /** The same for positions in another unit: see Positions::unit. */
  RegionalField
  inUnit (double unit) const;
};

/** What one point of a sample shows of such a number. */
struct LocalValue
{
  Eigen::Vector3f place;
  float value;
};

/** Points of a sample in a region at least, where a quantile over it should be that of the noise within a tenth. */
constexpr std::size_t usual_region_size = 64;

/** A quantile over regions of a sample.
  * \param[in] sample at least one point, in any order
  * \param[in] spacing between neighbouring points, > 0
  * \param[in] level in [0, 1), that of the median for .5
  * \param[in] region_size of the sample in a region at least, at most one less than twice that; or all where it has
  * fewer */
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
