// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/noise/regional_field.h>
#include <pcl_normal_smoothing/core/parallel_for.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** How the noise of a cloud varies from place to place, as scanners measure far, dark or slanting surfaces less
  * well: regions, each with a factor on the cloud's sigma. */
struct NoiseField
{
  /** sigma of a region over that of the cloud, > 0. No regions: the noise is the same everywhere. */
  RegionalField factors;

  bool
  isEven () const
  {
    return factors.regions.empty ();
  }

  /** sigma at a place over that of the cloud. */
  float
  factorAt (const Eigen::Vector3f& place) const
  {
    return factors.valueAt (place, 1);
  }

  float
  smallestFactor () const;

  float
  largestFactor () const;

  /** The same for positions in another unit: see Positions::unit. */
  NoiseField
  inUnit (double unit) const
  {
    return {factors.inUnit (unit)};
  }
};

/** The squares of factorAt for all nodes; empty if the field is even. */
Numbers
varianceFactors (const NoiseField& field, const Positions& positions, const Execution& execution);
} // namespace core
} // namespace pcl_normal_smoothing
