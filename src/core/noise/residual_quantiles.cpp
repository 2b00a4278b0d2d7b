// SPDX-License-Identifier: BSD-3-Clause
#include "residual_quantiles.h"

#include "../quantile.h"
#include "../ramp.h"

#include <algorithm>
#include <cmath>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
struct Quantile
{
  double level;
  /** The quantile of chi-square with 2, 6 and 10 degrees of freedom, over these. */
  std::array<double, 3> of_chi_square;
};

constexpr Quantile bottom = {.05, {.0513, .2726, .394}}, lowest = {.1, {.1054, .3674, .4865}},
                   lower = {.25, {.2877, .5758, .6737}}, median = {.5, {.6931, .891, .934}},
                   upper = {.75, {1.3863, 1.3068, 1.2549}}, highest = {.9, {2.3026, 1.7741, 1.5987}};

// extrapolated () is the smaller neighbourhood's variance less slope * trust * (larger - smaller), and at least
// least_extrapolated times the smaller. The slope goes by the number of points of the larger; the trust is 1 while
// (larger - smaller) / smaller is up to trusted_excess, and 0 from twice that on.
constexpr double slope_of_12 = .3, slope_of_16 = .4, steep_slope_of_12 = .9;
constexpr double trusted_excess = 2.5, trusted_excess_of_upper = 3;
constexpr double least_extrapolated = .2;

// Factors on the extrapolated variances of the quantiles; of the upper quartile 1. The last is for the lower quartile
// with the steep slope, below which the upper one does not count.
constexpr double factor_of_lower = 1.1, factor_of_median = 1.05, least_of_lower = .75;

// Ratios of variances where coordinates come in steps as large as the noise: the 8 nearest often lie in one plane, the
// 12 nearest do not.
constexpr double quantised_12_over_8 = 5, quantised_16_over_12 = 1.4;

// Upper bound on the growth of the upper quartile from the 12 to the 16 nearest, as a ratio of sigmas, where there is
// hardly any detail.
constexpr double most_growth_without_detail = 1.07;

// Dense relief, in ratios of sigmas: the lowest quantiles show one noise; the growth from which relief is seen, and by
// how much more in full; the bound on sigma over that of the lowest decile.
constexpr double one_noise = .85;
constexpr double growth_in_relief = 1.2, growth_in_relief_width = .1;
constexpr double most_in_relief = 1.15;

// Noise along rays, in ratios of sigmas: the bounds below which slant is seen, and by how much lower in full.
constexpr double slant_lower_over_upper = .92, slant_lower_over_upper_width = .05;
constexpr double slant_lowest_over_lower = .96, slant_lowest_over_lower_width = .08;
constexpr double slant_growth = 1.22, slant_growth_width = .08;

// Sigma of surfaces that face the rays over that of the 9th decile; and up to what that counts, in variances over the
// upper quartile (1.2 in sigmas) and over the median (1.44).
constexpr double facing_factor = 1.3;
constexpr double facing_of_upper = 1.44, facing_of_median = 2.07;

// Between scan lines, in ratios of sigmas: the correction of the 12 nearest; and the growth to the 16 nearest beyond
// which there are edges and detail.
constexpr double factor_across_lines = 1.15, most_growth_across_lines = 1.15;

/** The variance of the noise for which the residuals have this quantile. */
double
varianceBy (const Quantile& by, const ResidualVariances& variances, std::size_t size)
{
  return quantile (variances[size], by.level) / by.of_chi_square[size];
}

/** The square root of the ratio of two variances; 1 if both are 0. */
double
ratioOfSigmas (double a, double b)
{
  return a == b ? 1 : std::sqrt (a / b);
}

/** The variance extrapolated to a neighbourhood of no size, from a small and a large one, as curvature adds more to
  * the larger. But if that has many times the variance, quadrics do not fit the neighbourhoods, and the difference
  * does not count. */
double
extrapolated (double small, double large, double slope, double most_excess)
{
  const double excess = std::max (0.0, large - small);
  const double trust = std::clamp (2 - excess / (most_excess * small + 1e-30), 0.0, 1.0);
  return std::max (small - slope * trust * excess, least_extrapolated * small);
}

bool
isQuantised (double by_8, double by_12, double by_16)
{
  return by_12 > quantised_12_over_8 * by_8 && by_16 < quantised_16_over_12 * by_12;
}

/** Residuals of the largest neighbourhoods over those of the smallest, as a ratio of sigmas: 1 without detail. */
double
growthOf (const Quantile& by, const ResidualVariances& variances)
{
  return ratioOfSigmas (varianceBy (by, variances, of_16), varianceBy (by, variances, of_8));
}

/** Sigma where dense relief spoils the lower quartile too, but the quantiles below show a single noise. \return at
  * most \a sigma, which is by the other quantiles */
double
sigmaInRelief (const ResidualVariances& variances, double sigma)
{
  const double least = varianceBy (lowest, variances, of_12);
  const bool is_one_noise = least > 0 && ratioOfSigmas (varianceBy (bottom, variances, of_12), least) > one_noise;
  const double certainty =
      is_one_noise ? ramp (growthOf (lower, variances), growth_in_relief, growth_in_relief_width) : 0;
  return sigma - certainty * std::max (0.0, sigma - most_in_relief * std::sqrt (least));
}

/** The smallest estimate: edges spoil the upper quantiles, other sheets all but the lower. */
double
leastSigma (const ResidualVariances& variances)
{
  const std::size_t smallest = smallestToTrust (variances);
  const double lower_smallest = varianceBy (lower, variances, smallest),
               lower_12 = varianceBy (lower, variances, of_12);
  const double low = extrapolated (lower_smallest, lower_12, slope_of_12, trusted_excess),
               least = extrapolated (lower_smallest, lower_12, steep_slope_of_12, trusted_excess);
  const double middle = extrapolated (varianceBy (median, variances, smallest), varianceBy (median, variances, of_12),
                                      slope_of_12, trusted_excess);
  const double high = extrapolated (varianceBy (upper, variances, smallest), varianceBy (upper, variances, of_16),
                                    slope_of_16, trusted_excess_of_upper);
  return sigmaInRelief (variances, std::sqrt (std::min ({factor_of_lower * low, factor_of_median * middle,
                                                         std::max (high, least_of_lower * least)})));
}

/** Certainty, 0 to 1, that the eight nearest do not show the noise: their residuals are far below those of 12, which
  * are hardly below those of 16, unlike with detail, and much the same everywhere, unlike with relief. */
double
certaintyOfClumps (const ResidualVariances& variances)
{
  constexpr double least_of_12 = 1.8, sure_of_12 = 2.1; // over the variance of the 8 nearest
  constexpr double most_of_16 = 1.75, sure_of_16 = 1.5; // over that of the 12 nearest
  constexpr double least_of_lowest = .7, sure_of_lowest = .8;
  const double by_8 = varianceBy (lower, variances, of_8), by_12 = varianceBy (lower, variances, of_12),
               by_16 = varianceBy (lower, variances, of_16);
  if (!(by_8 > 0) || isQuantised (by_8, by_12, by_16))
    return 0;
  return ramp (by_12 / by_8, least_of_12, sure_of_12 - least_of_12) *
         (1 - ramp (by_16 / by_12, sure_of_16, most_of_16 - sure_of_16)) *
         ramp (ratioOfSigmas (varianceBy (lowest, variances, of_12), by_12), least_of_lowest,
               sure_of_lowest - least_of_lowest);
}

/** Sigma of surfaces that face the rays, on the large side, which slanting ones tolerate. Outliers do not affect the
  * median. */
double
facingSigma (const ResidualVariances& variances)
{
  return facing_factor * std::sqrt (std::min ({varianceBy (highest, variances, of_8),
                                               facing_of_upper * varianceBy (upper, variances, of_8),
                                               facing_of_median * varianceBy (median, variances, of_8)}));
}
} // namespace

std::size_t
smallestToTrust (const ResidualVariances& variances)
{
  return isQuantised (varianceBy (lower, variances, of_8), varianceBy (lower, variances, of_12),
                      varianceBy (lower, variances, of_16))
             ? of_12
             : of_8;
}

std::size_t
sizeForField (const ResidualVariances& variances)
{
  const double growth = ratioOfSigmas (varianceBy (upper, variances, of_16), varianceBy (upper, variances, of_12));
  return growth < most_growth_without_detail ? of_12 : smallestToTrust (variances);
}

double
certaintyOfSlant (const ResidualVariances& variances)
{
  const auto between = [&] (const Quantile& a, const Quantile& b, std::size_t size) {
    return ratioOfSigmas (varianceBy (a, variances, size), varianceBy (b, variances, size));
  };
  const auto below = [] (double ratio, double most, double width) { return ramp (most, ratio, width); };
  return below (between (lower, upper, of_12), slant_lower_over_upper, slant_lower_over_upper_width) *
         below (between (lowest, lower, of_8), slant_lowest_over_lower, slant_lowest_over_lower_width) *
         below (growthOf (highest, variances), slant_growth, slant_growth_width);
}

double
sigmaBy (const ResidualVariances& variances, double certainty_of_slant)
{
  const double least = leastSigma (variances);
  return least + certainty_of_slant * std::max (0.0, facingSigma (variances) - least);
}

double
sigmaInClumps (const ResidualVariances& variances, double sigma)
{
  const double by_more = extrapolated (varianceBy (lower, variances, of_12), varianceBy (lower, variances, of_16),
                                       slope_of_16, trusted_excess);
  return sigma + certaintyOfClumps (variances) * std::max (0.0, std::sqrt (factor_of_lower * by_more) - sigma);
}

double
sigmaAcrossLines (const ResidualVariances& variances)
{
  double sigma = 0;
  for (const Quantile& by : {highest, upper, median}) {
    const double by_12 = varianceBy (by, variances, of_12);
    sigma = factor_across_lines * std::sqrt (by_12);
    if (ratioOfSigmas (varianceBy (by, variances, of_16), by_12) < most_growth_across_lines)
      break;
  }
  return sigma;
}
} // namespace core
} // namespace pcl_normal_smoothing
