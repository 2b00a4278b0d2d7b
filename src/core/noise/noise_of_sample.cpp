// SPDX-License-Identifier: BSD-3-Clause
#include "noise_of_sample.h"
#include "../quantile.h"
#include "../ramp.h"
#include "../spacing.h"
#include "noise_field_estimate.h"
#include "residual_quantiles.h"

#include <algorithm>
#include <cmath>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
/** Correction factor for sigma: the larger the noise relative to the spacing, the more of it a quadric follows. Fitted,
  * like the next: doc/reading_noise.md, "What a quadric swallows".
  * \param[in] ratio of the estimated sigma to the spacing */
double
factorOfQuadrics (double ratio)
{
  return 1 + .3 * ratio + 1.2 * ratio * ratio;
}

/** Factor by which residuals make the noise of a single point look too small, by the ratio of its true sigma to the
  * spacing around it; on the large side. */
double
factorOfDensity (double ratio)
{
  const double bounded = std::min (ratio, 10.0); // exceeded by near copies
  return std::sqrt (1 + 2.2 * bounded * bounded);
}

/** Factors on sigma, one per point of a sample. */
using Factors = std::vector<double>;

/** Factors that convert the noise shown by a point to that of a place with the cloud's usual density and noise. */
Factors
correctionsOf (const NoiseSample& sample, const NoiseEstimate& noise)
{
  const double usual = factorOfDensity (noise.sigma / noise.spacing);
  Factors factors;
  for (const NoiseSample::Residuals& residuals : sample.of_nodes) {
    const double local = noise.field.factorAt (residuals.place);
    const double hidden = factorOfDensity (noise.sigma * local / (spacing_of_eighth * residuals.distance)) / usual;
    factors.push_back ((residuals.distance > 0 ? hidden : 1) / local); // copies of a point have no density
  }
  return factors;
}

/** Calls \a use (place, variance) with the corrected variances of all neighbourhoods of one size, except those too
  * short to have one. */
template <typename Use>
void
forEachVariance (const NoiseSample& sample, const Factors& factors, std::size_t size, const Use& use)
{
  for (std::size_t s = 0; s < sample.of_nodes.size (); ++s)
    if (const float variance = sample.of_nodes[s].variances[size]; std::isfinite (variance))
      use (sample.of_nodes[s].place, static_cast<float> (factors[s] * factors[s] * variance));
}

ResidualVariances
corrected (const NoiseSample& sample, const Factors& factors)
{
  ResidualVariances variances;
  for (std::size_t size = 0; size < variances.size (); ++size)
    forEachVariance (sample, factors, size,
                     [&] (const Eigen::Vector3f&, float variance) { variances[size].push_back (variance); });
  return variances;
}

/** How points are distributed on the surface: all over it, with or without clumps here and there, or along the lines
  * of a scanner, with gaps in between. */
enum class Pattern
{
  SCATTERED,
  CLUMPED,
  SCAN_LINES
};

/** The corrected variances of neighbourhoods of one size, with their places. */
std::vector<LocalValue>
localVariances (const NoiseSample& sample, const Factors& factors, std::size_t size)
{
  std::vector<LocalValue> local;
  forEachVariance (sample, factors, size, [&] (const Eigen::Vector3f& place, float variance) {
    local.push_back ({place, variance});
  });
  return local;
}

// Ratio of the 9th to the 1st decile of the sigmas of regions that chance can explain: the more degrees of freedom a
// neighbourhood has, the less its variance scatters.
constexpr double spread_of_8 = 1.4, spread_of_12 = 1.25;

NoiseField
fieldOf (const NoiseSample& sample, Pattern pattern, double certainty_of_detail, const NoiseEstimate& noise)
{
  const Factors factors = correctionsOf (sample, noise);
  const std::size_t size = pattern == Pattern::SCAN_LINES ? of_12 : sizeForField (corrected (sample, factors));
  const OtherCauses others = {noise.sigma / noise.spacing, size == of_8 ? spread_of_8 : spread_of_12,
                              certainty_of_detail};
  return estimateNoiseField (localVariances (sample, factors, size), noise.spacing, others);
}

/** How much of the certainty of slant remains where the noise varies as in \a field: all of it while the regions differ
  * no more than slant alone makes them, nothing where the noise itself varies. */
double
shareOfSlant (const NoiseField& field)
{
  constexpr double most_by_slant = 2.8, surely_more = 3.3; // 9th decile of the factors over the 1st
  const std::vector<float> factors = field.factors.values ();
  return 1 - ramp<double> (quantile (factors, .9), most_by_slant * quantile (factors, .1),
                           (surely_more - most_by_slant) * quantile (factors, .1));
}

/** \param[in,out] certainty_of_slant on entry the least that counts, on return the larger of that and what is seen
  * \param[in,out] noise with spacing and field known; sigma is set */
void
estimateSigma (const NoiseSample& sample,
               Pattern pattern,
               double certainty_of_detail,
               double& certainty_of_slant,
               NoiseEstimate& noise)
{
  constexpr int iterations = 3;
  for (int iteration = 0; iteration < iterations; ++iteration) {
    const ResidualVariances variances = corrected (sample, correctionsOf (sample, noise));
    if (iteration == 0) // later on sigma is larger, and density would seem to explain more
      certainty_of_slant = std::max (certainty_of_slant, (1 - certainty_of_detail) * certaintyOfSlant (variances));
    const double sigma =
        pattern == Pattern::SCAN_LINES ? sigmaAcrossLines (variances) : sigmaBy (variances, certainty_of_slant);
    noise.sigma = static_cast<float> (sigma * factorOfQuadrics (sigma / noise.spacing));
    if (pattern == Pattern::CLUMPED)
      noise.sigma = static_cast<float> (sigmaInClumps (variances, noise.sigma));
  }
}

NoiseEstimate
noiseIn (const NoiseSample& sample, Pattern pattern)
{
  std::vector<float> distances;
  for (const NoiseSample::Residuals& residuals : sample.of_nodes)
    if (residuals.distance > 0)
      distances.push_back (residuals.distance);
  const double spacing = spacing_of_eighth * quantile (distances, .5);
  if (!(spacing > 0) || sample.short_rows > 3 * sample.of_nodes.size ())
    return {};
  NoiseEstimate noise;
  noise.spacing = static_cast<float> (spacing);
  const Factors as_they_are (sample.of_nodes.size (), 1);
  const double detail = pattern == Pattern::SCAN_LINES
                            ? 0
                            : certaintyOfDetail (localVariances (sample, as_they_are, of_12), noise.spacing);
  double slant = 0;
  estimateSigma (sample, pattern, detail, slant, noise);
  noise.field = fieldOf (sample, pattern, detail, noise);
  if (!noise.field.isEven ()) {
    slant *= shareOfSlant (noise.field);
    estimateSigma (sample, pattern, detail, slant, noise);
  }
  return noise;
}

NoiseEstimate
noiseInLayers (NoiseSample sample, const LayerEstimate& layers)
{
  NoiseEstimate noise = noiseIn (sample, Pattern::SCATTERED);
  std::vector<float> steps;
  for (const NoiseSample::Residuals& residuals : sample.of_nodes)
    steps.push_back (layers.steps.valueAt (residuals.place, 0));
  const float step = quantile (steps, .5);
  if (!(noise.spacing > 0 && step > 0))
    return noise;
  sample.dropPlanes ();
  if (!sample.of_nodes.empty ())
    noise = noiseIn (sample, Pattern::SCATTERED);
  noise.sigma = std::max (noise.sigma, layers.noise_of_step * step);
  noise.field = relativeField (layers.steps, step);
  return noise;
}
} // namespace

NoiseEstimate
noiseOfSample (const NoiseSample& sample)
{
  return noiseIn (sample, Pattern::CLUMPED);
}

NoiseEstimate
noiseOfThinnedSample (const NoiseSample& sample)
{
  return noiseIn (sample, Pattern::SCATTERED);
}

NoiseEstimate
noiseOfSample (const NoiseSample& sample, const Widening& widening)
{
  if (widening.layers.hasLayers ())
    return noiseInLayers (sample, widening.layers);
  NoiseEstimate noise = noiseIn (sample, widening.lines.hasLines () ? Pattern::SCAN_LINES : Pattern::CLUMPED);
  noise.sigma = std::min (noise.sigma, widening.lines.most_sigma);
  noise.sigma = widening.wide_noise.sigma > 0 ? widening.wide_noise.sigma : widening.rounding.atLeast (noise.sigma);
  if (widening.projects () ||
      !widening.wide_noise.is_everywhere) // the sample is of points that moved, or of rows that differ
    noise.field = widening.wide_noise.field;
  return noise;
}
} // namespace core
} // namespace pcl_normal_smoothing
