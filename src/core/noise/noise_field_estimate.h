// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "regional_quantiles.h"

#include <pcl_normal_smoothing/core/noise/noise_field.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** Certainty, 0 to 1, that residuals of quadrics are detail and not noise: within regions they differ more than those
  * of uniform noise.
  * \param[in] variances of the 12 nearest for a sample of the whole cloud, in any order; with fewer than three quarters
  * of noise_sample_size the result is 0
  * \param[in] spacing between neighbouring points, > 0 */
double
certaintyOfDetail (const std::vector<LocalValue>& variances, float spacing);

/** What makes regions differ besides noise that varies. */
struct OtherCauses
{
  /** sigma over the spacing: the smaller, the more must regions differ, as detail looks like noise. */
  double ratio;
  /** Ratio of the 9th to the 1st decile of the sigmas of regions that chance explains. */
  double spread_by_chance;
  /** 0 to 1: reduces the differences of regions by this share. */
  double certainty_of_detail;
};

/** \param[in] variances residual variances for a sample of the whole cloud, in any order
  * \param[in] spacing between neighbouring points, > 0
  * \return factors relative to the median of the sample; no regions if they hardly differ, or the sample is too
  * small */
NoiseField
estimateNoiseField (const std::vector<LocalValue>& variances, float spacing, const OtherCauses& others);

/** The field of a noise proportional to the regions' values, with factor 1 at the value \a usual, which is > 0. */
NoiseField
relativeField (RegionalField values, float usual);
} // namespace core
} // namespace pcl_normal_smoothing
