// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/positions.h>

#include <vector>

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
} // namespace core
} // namespace pcl_normal_smoothing
