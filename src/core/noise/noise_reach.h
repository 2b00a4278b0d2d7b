// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "regional_quantiles.h"
#include "thinned_noise.h"

namespace pcl_normal_smoothing
{
namespace core
{
/** Estimated sigma over the spacing. Up to this ratio neighbourhoods are wider than the noise, and residuals of
  * quadrics show all of it: it is resolved. Only in clumps may some be hidden, as their points are closer than the
  * spacing says. */
constexpr double resolved_ratio = .3;

/** A halving multiplies the spacing by 1.4. Resolved noise stays the same, and the ratio drops to .71 of what it
  * was, at least below this share. Of other noise the wider neighbourhoods show more, and the ratio drops less. */
constexpr double resolved_drop = .83;

/** Upper bound on halvings beyond the one that shows the noise, and on the growth of residuals by them:
  * neighbourhoods that miss a third of sigma in detail leave 1.05 times the residuals. */
constexpr int most_halvings_without_loss = 2;
constexpr double max_growth_without_loss = 1.05;

/** The largest sigma of all clouds up to the one that resolves the noise: thicker ones hide a part of it, and in
  * thinner ones quadrics mistake a part of it for detail. */
float
sigmaOf (ThinnedNoise& noise, int halvings_to_resolve);

/** Number of halvings, 0 to 2, beyond the one that resolves the noise, by which neighbourhoods can grow without
  * losing detail. */
int
halvingsWithoutLoss (ThinnedNoise& noise, int halvings_to_resolve);

/** sigma over the spacing of the whole cloud, at the places of the sample.
  * \param[in] sigma the usual one, as shown after \a halvings */
std::vector<LocalValue>
localRatios (ThinnedNoise& noise, int halvings, float sigma);

/** Number of halvings of the cloud after which rows reach far enough, in sigmas.
  * \param[in] without_loss see halvingsWithoutLoss
  * \param[in] ratios see localRatios */
std::vector<LocalValue>
halvingsToReach (int without_loss, std::vector<LocalValue> ratios, std::uint32_t row_length);
} // namespace core
} // namespace pcl_normal_smoothing
