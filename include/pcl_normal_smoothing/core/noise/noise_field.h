// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/noise/regional_field.h>
#include <pcl_normal_smoothing/core/parallel_for.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** How the noise of a cloud varies from place to place: a scanner measures worse what is far, dark or slanting.
  * Regions, each with its part of the cloud's sigma. */
struct NoiseField
{
  /** sigma there over that of the cloud, > 0. None: the noise is the same everywhere. */
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

/** How sure it is, 0 to 1, that what quadrics leave is detail and not noise: it differs more inside of regions than one
  * noise would.
  * \param[in] variances of the 12 nearest, what a sample of the whole cloud shows, in any order; 0 for less than three
  * quarters of noise_sample_size
  * \param[in] spacing between neighbouring points, > 0 */
double
certaintyOfDetail (const std::vector<LocalValue>& variances, float spacing);

/** \param[in] variances what a sample of the whole cloud shows, in any order
  * \param[in] spacing between neighbouring points, > 0
  * \param[in] ratio sigma over it: the smaller, the more must regions differ, for detail looks like noise
  * \param[in] certainty_of_detail 0 to 1: so much less do regions count
  * \return the factor 1 is the median of the sample; no regions where they hardly differ, or the sample is too small to
  * tell */
NoiseField
estimateNoiseField (const std::vector<LocalValue>& variances,
                    float spacing,
                    double ratio,
                    double certainty_of_detail = 0);

/** The field of a noise that is as much larger in a region as its value is larger than \a usual, which is > 0. */
NoiseField
relativeField (RegionalField values, float usual);

/** The squares of factorAt for all nodes; empty where the field is even. */
Numbers
varianceFactors (const NoiseField& field, const Positions& positions, const Execution& execution);
} // namespace core
} // namespace pcl_normal_smoothing
