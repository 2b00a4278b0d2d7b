// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "thinned_noise.h"

namespace pcl_normal_smoothing
{
namespace core
{
/** Of sigma, as it is estimated, to the spacing. Up to this ratio neighbourhoods are wider than the noise, so that
  * quadrics show all of it: it is resolved. Only in clumps may more be hidden, for there points are closer than the
  * spacing says. */
constexpr double resolved_ratio = .3;

/** A halving makes the spacing 1.4 times as wide. Noise that is resolved looks the same then, and the ratio drops to
  * .71 of what it was, or at least below this share. Of noise that is not, the wider neighbourhoods show more, and
  * it drops less. */
constexpr double resolved_drop = .83;

/** So often neighbourhoods may grow beyond the halving that shows the noise, where what quadrics leave grows by no more
  * than that: one that misses a third of sigma in detail leaves 1.05 times as much. */
constexpr int most_halvings_without_loss = 2;
constexpr double max_growth_without_loss = 1.05;

/** The largest sigma of all clouds up to the one that resolves the noise: thicker ones hide a part of it, and in
  * thinner ones quadrics take a part of it for detail. */
float
sigmaOf (ThinnedNoise& noise, int halvings_to_resolve);

/** How often, 0 to 2, the cloud can be halved beyond the one that resolves the noise before neighbourhoods of its
  * width lose detail. */
int
halvingsWithoutLoss (ThinnedNoise& noise, int halvings_to_resolve);

/** sigma over the spacing of the whole cloud, at the places of the sample.
  * \param[in] sigma the usual one, as so many halvings show it */
std::vector<LocalValue>
localRatios (ThinnedNoise& noise, int halvings, float sigma);

/** How often the cloud has to be halved for rows to reach as many sigmas as they should.
  * \param[in] without_loss see halvingsWithoutLoss
  * \param[in] ratios see localRatios */
std::vector<LocalValue>
halvingsToReach (int without_loss, std::vector<LocalValue> ratios, std::uint32_t row_length);
} // namespace core
} // namespace pcl_normal_smoothing
