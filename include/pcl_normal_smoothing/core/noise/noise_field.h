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

/** Certainty, 0 to 1, that residuals of quadrics are detail and not noise: within regions they differ more than those
  * of uniform noise.
  * \param[in] variances of the 12 nearest for a sample of the whole cloud, in any order; with fewer than three quarters
  * of noise_sample_size the result is 0
  * \param[in] spacing between neighbouring points, > 0 */
double
certaintyOfDetail (const std::vector<LocalValue>& variances, float spacing);

/** \param[in] variances residual variances for a sample of the whole cloud, in any order
  * \param[in] spacing between neighbouring points, > 0
  * \param[in] ratio of sigma to the spacing: the smaller, the more must regions differ, as detail looks like noise
  * \param[in] spread_by_chance ratio of the 9th to the 1st decile of the sigmas of regions that chance explains
  * \param[in] certainty_of_detail 0 to 1: reduces the differences of regions by this share
  * \return factors relative to the median of the sample; no regions if they hardly differ, or the sample is too
  * small */
NoiseField
estimateNoiseField (const std::vector<LocalValue>& variances,
                    float spacing,
                    double ratio,
                    double spread_by_chance,
                    double certainty_of_detail);

/** The field of a noise proportional to the regions' values, with factor 1 at the value \a usual, which is > 0. */
NoiseField
relativeField (RegionalField values, float usual);

/** The squares of factorAt for all nodes; empty if the field is even. */
Numbers
varianceFactors (const NoiseField& field, const Positions& positions, const Execution& execution);
} // namespace core
} // namespace pcl_normal_smoothing
