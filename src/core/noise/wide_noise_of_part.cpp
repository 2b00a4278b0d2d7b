// SPDX-License-Identifier: BSD-3-Clause
#include "wide_noise_of_part.h"

#include "../quantile.h"
#include "noise_reach.h"
#include "residual_quantiles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
// Where the noise is wide in a part of the cloud only. From one halving to four, neighbourhoods become 2.8 times as wide.
constexpr int few_halvings = 1, more_halvings = 4;
constexpr float min_shown_ratio = .3f;
constexpr float growth_of_wide = 1.3f, growth_near_wide = 1.2f;
constexpr std::size_t least_part = 64; // of the sample
constexpr double min_growth_in_part = 1.4;
constexpr double max_spread_in_part = 1.2;

/** A number of the residuals at the places of the sample, by regions; those where it is not finite do not count. */
template <typename Number>
RegionalField
regionalNumbers (ThinnedNoise& cloud, const Number& number)
{
  const std::vector<NoiseSample::Residuals>& all = cloud.sample (0).of_nodes;
  std::vector<LocalValue> numbers;
  for (std::size_t s = 0; s < all.size (); ++s)
    if (const float value = number (s); std::isfinite (value))
      numbers.push_back ({all[s].place, value});
  return numbers.empty () ? RegionalField () : regionalMedians (numbers, cloud.noise (0).spacing);
}

/** How much more noise the nearest points show where more halvings thin the cloud, by regions: 1 where it is
  * resolved, or is small against their spacing. Without regions where it is so everywhere. */
RegionalField
growthOfNoise (ThinnedNoise& cloud)
{
  const auto sigma = [&cloud] (int halvings, std::size_t s) {
    return std::sqrt (cloud.sample (halvings).of_nodes[s].variances.front ());
  };
  const RegionalField ratios = regionalNumbers (cloud, [&] (std::size_t s) {
    return sigma (0, s) / (static_cast<float> (spacing_of_reach) * cloud.sample (0).of_nodes[s].distance);
  });
  const auto is_small = [] (const RegionalField::Region& region) { return region.value < min_shown_ratio; };
  if (std::all_of (ratios.regions.begin (), ratios.regions.end (), is_small))
    return {};
  for (const int halvings : {few_halvings, more_halvings})
    if (cloud.sample (halvings).of_nodes.size () != cloud.sample (0).of_nodes.size ())
      return {}; // where many points lie in one place these are not the same nodes
  RegionalField growth = regionalNumbers (cloud, [&] (std::size_t s) {
    return sigma (few_halvings, s) > 0 ? sigma (more_halvings, s) / sigma (few_halvings, s) : 1;
  });
  for (RegionalField::Region& region : growth.regions)
    if (ratios.valueAt (region.centre, 0) < min_shown_ratio)
      region.value = 1;
  return growth;
}

/** How far the quartiles of what quadrics leave are apart, as a ratio of sigmas: 1 of one noise, more of detail. */
double
spreadOf (const NoiseSample& sample)
{
  std::vector<float> variances;
  for (const NoiseSample::Residuals& residuals : sample.of_nodes)
    if (std::isfinite (residuals.variances[of_12]) && residuals.distance > 0)
      variances.push_back (residuals.variances[of_12] / (residuals.distance * residuals.distance));
  return std::sqrt (quantile (variances, .75) / (quartile_ratio_of_12 * quantile (variances, .25)));
}

/** Whether a part of the cloud hides noise, of which its regions show more and more as it is thinned. Detail does, too, but is not the
  * same all over it. */
bool
hidesNoiseInPart (ThinnedNoise& part)
{
  if (part.sample (0).of_nodes.size () < least_part || !(part.ratio (0) > resolved_ratio))
    return false;
  const double growth =
      part.ratio (more_halvings) / part.ratio (few_halvings) * std::exp2 (.5 * (more_halvings - few_halvings));
  return growth > min_growth_in_part && spreadOf (part.sample (0)) < max_spread_in_part;
}

/** \return how often the cloud has to be halved to resolve the noise of a part that hides it; 0: there is no surface */
int
halvingsToResolvePart (ThinnedNoise& part)
{
  for (int halvings = 1; halvings < part.mostHalvings (); ++halvings)
    if (part.ratio (halvings) < resolved_ratio && part.ratio (halvings + 1) < resolved_drop * part.ratio (halvings))
      return halvings;
  return 0;
}

/** sigma at the places of a sample. */
std::vector<LocalValue>
localSigmas (const NoiseSample& sample, const NoiseField& field, float sigma)
{
  std::vector<LocalValue> sigmas;
  for (const NoiseSample::Residuals& residuals : sample.of_nodes)
    sigmas.push_back ({residuals.place, sigma * field.factorAt (residuals.place)});
  return sigmas;
}

} // namespace

WideNoise
wideNoiseOfPart (ThinnedNoiseOfCloud& cloud)
{
  const NoiseEstimate& unthinned = cloud.noise (0);
  if (!(unthinned.spacing > 0) || cloud.mostHalvings () < more_halvings)
    return {};
  const RegionalField growth = growthOfNoise (cloud);
  constexpr float infinity = std::numeric_limits<float>::infinity ();
  ThinnedNoiseOfPart inner (cloud, growth, growth_of_wide, infinity), wide (cloud, growth, growth_near_wide, infinity),
      other (cloud, growth, -1, growth_near_wide);
  const int to_resolve = hidesNoiseInPart (inner) ? halvingsToResolvePart (inner) : 0;
  if (to_resolve == 0)
    return {};
  const float sigma = sigmaOf (wide, to_resolve);
  const NoiseField& field = wide.noise (to_resolve).field;
  std::vector<LocalValue> halvings = halvingsToReach (halvingsWithoutLoss (wide, to_resolve),
                                                      localRatios (wide, to_resolve, sigma), cloud.rowLength ());
  std::vector<LocalValue> sigmas = localSigmas (wide.sample (to_resolve), field, sigma);
  for (const LocalValue& local : localSigmas (other.sample (0), unthinned.field, unthinned.sigma)) {
    sigmas.push_back (local);
    halvings.push_back ({local.place, 0});
  }
  std::vector<float> values;
  for (const LocalValue& local : sigmas)
    values.push_back (local.value);
  WideNoise noise;
  noise.sigma = quantile (values, .5);
  if (!(noise.sigma > 0)) // most of the cloud is clean
    return {};
  noise.field = relativeField (regionalMedians (sigmas, unthinned.spacing), noise.sigma);
  noise.halvings = regionalMedians (halvings, unthinned.spacing);
  noise.is_everywhere = false;
  return noise;
}
} // namespace core
} // namespace pcl_normal_smoothing
