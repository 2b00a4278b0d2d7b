// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/layer_bridging.h>
#include <pcl_normal_smoothing/core/noise_estimate.h>
#include <pcl_normal_smoothing/core/quantile.h>

#include <algorithm>
#include <cmath>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
constexpr double pi = 3.14159265358979;

/** The variance at no size of neighbourhood, from those at a small and a large one: curvature adds to the larger more. But
  * where it is many times the smaller, the neighbourhoods do not fit a quadric, and the difference tells nothing. */
double
extrapolated (double small, double large, double slope, double largest_excess)
{
  const double excess = std::max (0.0, large - small);
  const double trust = std::clamp (2 - excess / (largest_excess * small + 1e-30), 0.0, 1.0);
  return std::max (small - slope * trust * excess, 0.2 * small);
}

/** Coordinates in steps as large as the noise (depth cameras): the eight nearest points often lie in one plane exactly, and
  * show far less than the larger neighbourhoods, which agree. Curvature makes them differ too. */
bool
isQuantised (double of_8, double of_12, double of_16)
{
  return of_12 > 5 * of_8 && of_16 < 1.3 * of_12;
}

double
spacingOf (double distance_of_eighth)
{
  return distance_of_eighth * std::sqrt (pi / 8);
}

/** A quadric follows the more of the noise the larger it is against the spacing: a factor of sigma.
  * \param[in] ratio of sigma, as it is read, to the spacing */
double
whatQuadricsFollow (double ratio)
{
  return 1 + .3 * ratio + 1.2 * ratio * ratio;
}

/** How much too small quadrics make the noise look, by the ratio of the sigma that there is: of a point, not of the usual one, and
  * on the large side. */
double
whatDensityHides (double ratio)
{
  const double bounded = std::min (ratio, 10.0); // nearly copies
  return std::sqrt (1 + 2.2 * bounded * bounded);
}

/** Of sigma, one for every point of a sample. */
using Factors = std::vector<double>;

/** What turns the noise that a point shows into that of a place as dense as the cloud is, and with its usual noise. */
Factors
correctionsOf (const NoiseSample& sample, const NoiseEstimate& noise)
{
  const double usual = whatDensityHides (noise.sigma / noise.spacing);
  Factors factors;
  for (const NoiseSample::Residuals& residuals : sample.of_nodes) {
    const double local = noise.field.factorAt (residuals.place);
    const double hidden = whatDensityHides (noise.sigma * local / spacingOf (residuals.distance)) / usual;
    factors.push_back ((residuals.distance > 0 ? hidden : 1) / local); // copies of a point have no density
  }
  return factors;
}

/** Those through the 8, 12 and 16 nearest. */
using Variances = std::array<std::vector<float>, 3>;

Variances
corrected (const NoiseSample& sample, const Factors& factors)
{
  Variances variances;
  for (std::size_t s = 0; s < sample.of_nodes.size (); ++s)
    for (std::size_t i = 0; i < variances.size (); ++i)
      if (const float variance = sample.of_nodes[s].variances[i]; std::isfinite (variance))
        variances[i].push_back (static_cast<float> (factors[s] * factors[s] * variance));
  return variances;
}

// Quantiles over those of chi-square by its 2, 6 and 10 degrees of freedom.
double
lowerQuartile (const Variances& variances, std::size_t i)
{
  constexpr std::array<double, 3> of_chi_square = {.2877, .5758, .6737};
  return quantile (variances[i], .25) / of_chi_square[i];
}

/** Which neighbourhoods tell most of the noise alone. */
std::size_t
smallestToTrust (const Variances& variances)
{
  return isQuantised (lowerQuartile (variances, 0), lowerQuartile (variances, 1), lowerQuartile (variances, 2)) ? 1 : 0;
}

/** Edges spoil the upper quantiles, other sheets all but the lower ones. */
double
sigmaBy (const Variances& variances)
{
  const double lower_8 = lowerQuartile (variances, smallestToTrust (variances)),
               lower_12 = lowerQuartile (variances, 1);
  const auto& [of_8, of_12, of_16] = variances;
  const double lower = extrapolated (lower_8, lower_12, .3, 2.5), lowest = extrapolated (lower_8, lower_12, .9, 2.5);
  const double median = extrapolated (quantile (of_8, .5) / .6931, quantile (of_12, .5) / .891, .3, 2.5);
  const double upper = extrapolated (quantile (of_8, .75) / 1.3863, quantile (of_16, .75) / 1.2549, .4, 3);
  return std::sqrt (std::min ({1.1 * lower, 1.05 * median, std::max (upper, .75 * lowest)}));
}

NoiseField
fieldOf (const NoiseSample& sample, const NoiseEstimate& noise)
{
  const Factors factors = correctionsOf (sample, noise);
  const std::size_t size = smallestToTrust (corrected (sample, factors));
  std::vector<LocalValue> local;
  for (std::size_t s = 0; s < sample.of_nodes.size (); ++s)
    if (const float variance = sample.of_nodes[s].variances[size]; std::isfinite (variance))
      local.push_back ({sample.of_nodes[s].place, static_cast<float> (factors[s] * factors[s] * variance)});
  return estimateNoiseField (local, noise.spacing, noise.sigma / noise.spacing);
}

/** \param[in,out] noise, its spacing and field known */
void
estimateSigma (const NoiseSample& sample, int iterations, NoiseEstimate& noise)
{
  for (int iteration = 0; iteration < iterations; ++iteration) {
    const double sigma = sigmaBy (corrected (sample, correctionsOf (sample, noise)));
    noise.sigma = static_cast<float> (sigma * whatQuadricsFollow (sigma / noise.spacing));
  }
}
} // namespace

NoiseEstimate
estimateNoise (const NeighborGraph& graph, const Positions& nodes, const Execution& execution)
{
  const NoiseEstimate noise = estimateNoise (sampleNoise (graph, nodes, execution));
  const LayerEstimate layers = estimateLayers (graph, nodes, execution);
  const auto wide = bridgeLayers (graph, nodes, layers, execution);
  if (!wide)
    return noise;
  NoiseEstimate of_wide = estimateNoise (sampleNoise (*wide, nodes, execution), layers);
  of_wide.spacing = noise.spacing;
  return of_wide;
}

NoiseEstimate
estimateNoise (const NoiseSample& sample)
{
  std::vector<float> distances;
  for (const NoiseSample::Residuals& residuals : sample.of_nodes)
    if (residuals.distance > 0)
      distances.push_back (residuals.distance);
  const double spacing = spacingOf (quantile (distances, .5));
  if (!(spacing > 0) || sample.short_rows > 3 * sample.of_nodes.size ())
    return {};
  NoiseEstimate noise;
  noise.spacing = static_cast<float> (spacing);
  estimateSigma (sample, 3, noise);
  noise.field = fieldOf (sample, noise);
  if (!noise.field.isEven ())
    estimateSigma (sample, 3, noise);
  return noise;
}

NoiseEstimate
estimateNoise (NoiseSample sample, const LayerEstimate& layers)
{
  NoiseEstimate noise = estimateNoise (sample);
  std::vector<float> steps;
  for (const NoiseSample::Residuals& residuals : sample.of_nodes)
    steps.push_back (layers.steps.valueAt (residuals.place, 0));
  const float step = quantile (steps, .5);
  if (!(noise.spacing > 0 && step > 0))
    return noise;
  sample.dropPlanes ();
  if (!sample.of_nodes.empty ())
    noise = estimateNoise (sample);
  noise.sigma = std::max (noise.sigma, layers.noise_of_step * step);
  noise.field = relativeField (layers.steps, step);
  return noise;
}
} // namespace core
} // namespace pcl_normal_smoothing
