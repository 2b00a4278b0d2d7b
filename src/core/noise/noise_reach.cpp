// SPDX-License-Identifier: BSD-3-Clause
#include "noise_reach.h"

#include "../spacing.h"

#include <algorithm>
#include <cmath>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
// Rows must reach as far as least_reach sigmas, or they are lost in the noise. Every further halving that costs no
// detail multiplies that by growth_of_reach. Maps with clumps, as of rooms and streets, count as losing nothing.
constexpr double least_reach = 4.25;
constexpr double growth_of_reach = 1.58;
} // namespace

float
sigmaOf (ThinnedNoise& noise, int halvings_to_resolve)
{
  float sigma = 0;
  for (int halvings = 0; halvings <= halvings_to_resolve; ++halvings)
    sigma = std::max (sigma, noise.noise (halvings).sigma);
  return sigma;
}

int
halvingsWithoutLoss (ThinnedNoise& noise, int halvings_to_resolve)
{
  if (noise.ratio (0) <= resolved_ratio) // in clumps
    return most_halvings_without_loss;
  const double all = max_growth_without_loss * noise.residual (halvings_to_resolve);
  int halvings = halvings_to_resolve;
  while (halvings < std::min (noise.mostHalvings (), halvings_to_resolve + most_halvings_without_loss) &&
         noise.residual (halvings + 1) <= all)
    ++halvings;
  return halvings - halvings_to_resolve;
}

std::vector<LocalValue>
localRatios (ThinnedNoise& noise, int halvings, float sigma)
{
  const NoiseEstimate& shown = noise.noise (halvings);
  std::vector<LocalValue> ratios;
  for (const NoiseSample::Residuals& residuals : noise.sample (halvings).of_nodes) {
    const double spacing = std::max<double> (spacing_of_eighth * residuals.distance, 1e-3 * shown.spacing);
    const double ratio = sigma * shown.field.factorAt (residuals.place) / spacing * std::exp2 (.5 * halvings);
    ratios.push_back ({residuals.place, static_cast<float> (ratio)});
  }
  return ratios;
}

std::vector<LocalValue>
halvingsToReach (int without_loss, std::vector<LocalValue> ratios, std::uint32_t row_length)
{
  const double sigmas = least_reach * std::pow (growth_of_reach, without_loss);
  const double reach = std::sqrt (row_length / M_PI); // in spacings
  for (LocalValue& local : ratios)
    local.value = static_cast<float> (std::max (0.0, 2 * std::log2 (sigmas * local.value / reach)));
  return ratios;
}
} // namespace core
} // namespace pcl_normal_smoothing
