// SPDX-License-Identifier: BSD-3-Clause
#include "noise_field_estimate.h"

#include "../quantile.h"
#include "../ramp.h"
#include "noise_sample.h"
#include "residual_quantiles.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
constexpr std::size_t min_regions = 4;
// Bounds the factors of regions, from below by the inverse: nothing divides by zero.
constexpr float max_factor = 32;

/** Ratio of the 9th to the 1st decile of the regions that chance, and detail that looks like noise, can explain. */
double
spreadBy (const OtherCauses& others)
{
  constexpr double of_detail = .04; // fitted, in spacings
  return others.spread_by_chance + of_detail / std::max (others.ratio, of_detail);
}

// How far above that ratio the field counts in full; in between it counts in part.
constexpr double spread_to_trust = .4;

/** A quantile of the residuals within regions, to be compared with their upper quartile. */
struct LowerQuantile
{
  double level;
  /** Ratio of the upper quartile to this quantile for residuals of even noise over 12 points. */
  float of_noise;
  /** A ratio of sigmas above this means detail; noise of cameras and scanners, edges included, reaches 1.16 and
    * 1.35. */
  double of_detail;
};

// Dense relief affects the lower quartile too, hence the lowest decile.
constexpr LowerQuantile lower_quantiles[] = {{.25, static_cast<float> (quartile_ratio_of_12), 1.2}, {.1, 3.557f, 1.4}};
// In smaller clouds a region is so large a part that noise and curvature vary within it. Not the full sample size:
// sampling by hash is not exact to the point.
constexpr std::size_t least_to_see_detail = noise_sample_size * 3 / 4;

/** How far differences between regions are trusted.
  * \param[in] spread ratio of the 9th to the 1st decile up to which they are not */
double
trustIn (const RegionalField& deviations, double spread)
{
  const std::vector<float> factors = deviations.values ();
  const double high = quantile (factors, .9), low = quantile (factors, .1);
  return ramp (high, spread * low, spread_to_trust * low + 1e-30);
}
} // namespace

double
certaintyOfDetail (const std::vector<LocalValue>& variances, float spacing)
{
  if (variances.size () < least_to_see_detail)
    return 0;
  const std::vector<float> upper = regionalQuantiles (variances, spacing, .75).values ();
  double certainty = 0;
  for (const LowerQuantile& by : lower_quantiles) {
    const std::vector<float> lower = regionalQuantiles (variances, spacing, by.level).values ();
    std::vector<float> spreads;
    for (std::size_t region = 0; region < upper.size (); ++region)
      spreads.push_back (upper[region] > 0 ? std::sqrt (upper[region] / (by.of_noise * lower[region])) : 1);
    certainty = std::max (certainty, ramp<double> (quantile (spreads, .5), by.of_detail, .1));
  }
  return certainty;
}

NoiseField
relativeField (RegionalField values, float usual)
{
  for (RegionalField::Region& region : values.regions)
    region.value = std::clamp (region.value / usual, 1 / max_factor, max_factor);
  return {values};
}

NoiseField
estimateNoiseField (const std::vector<LocalValue>& variances, float spacing, const OtherCauses& others)
{
  RegionalField field = regionalMedians (variances, spacing);
  for (RegionalField::Region& region : field.regions)
    region.value = std::sqrt (region.value);
  const auto trust = static_cast<float> ((1 - others.certainty_of_detail) * trustIn (field, spreadBy (others)));
  std::vector<float> of_sample;
  for (const LocalValue& point : variances)
    of_sample.push_back (field.valueAt (point.place, 1));
  const float usual = quantile (of_sample, .5);
  if (field.regions.size () < min_regions || !(trust > 0) || !(usual > 0))
    return {};
  NoiseField noise = relativeField (std::move (field), usual);
  for (RegionalField::Region& region : noise.factors.regions)
    region.value = 1 + trust * (region.value - 1);
  return noise;
}
} // namespace core
} // namespace pcl_normal_smoothing
