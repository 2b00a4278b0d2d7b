// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/noise/thinned_noise.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** Of sigma to the spacing, as they are read: up to this nothing is hidden but in clumps, and neighbourhoods that have to be wider had
  * better be that wide. */
constexpr double read_surely = .3;

/** A halving makes the spacing 1.4 times as wide, and the ratio .71 of what it was; where a part of the noise is hidden, more of it shows, and
  * the ratio falls to more than this. */
constexpr double max_fall = .83;

/** Of the distance of the eighth point, as in the estimate of the noise: sqrt (pi / 8). */
constexpr double spacing_of_reach = .6267;

/** The most that is seen up to where the noise is read: before, it is hidden in part; and there, the thinner the cloud the more do quadrics
  * miss for the sake of detail. */
float
sigmaOf (ThinnedNoise& noise, int halvings_to_read);

/** How often the cloud can be halved beyond that which shows the noise, 0 to 2, and nothing is lost by neighbourhoods that grow with it. */
int
halvingsWithoutLoss (ThinnedNoise& noise, int halvings_to_read);

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
