// SPDX-License-Identifier: BSD-3-Clause
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

/** \param[in] factor (distance of the eighth): of sigma where the points are as dense */
template <typename Factor>
double
sigmaBy (const NoiseSample& sample, const Factor& factor)
{
  std::array<std::vector<float>, 3> variances;
  for (const NoiseSample::Residuals& residuals : sample.of_nodes)
    for (std::size_t i = 0; i < variances.size (); ++i)
      if (std::isfinite (residuals.variances[i])) {
        const double f = residuals.distance > 0 ? factor (residuals.distance) : 1; // copies of a point have no density
        variances[i].push_back (static_cast<float> (f * f * residuals.variances[i]));
      }
  const auto& [of_8, of_12, of_16] = variances;
  // Quantiles over those of chi-square by its 2, 6 and 10 degrees of freedom. Edges spoil the upper ones, other sheets all
  // but the lower ones.
  const double lower_12 = quantile (of_12, .25) / .5758, lower_16 = quantile (of_16, .25) / .6737;
  double lower_8 = quantile (of_8, .25) / .2877;
  if (isQuantised (lower_8, lower_12, lower_16))
    lower_8 = lower_12;
  const double lower = extrapolated (lower_8, lower_12, .3, 2.5), lowest = extrapolated (lower_8, lower_12, .9, 2.5);
  const double median = extrapolated (quantile (of_8, .5) / .6931, quantile (of_12, .5) / .891, .3, 2.5);
  const double upper = extrapolated (quantile (of_8, .75) / 1.3863, quantile (of_16, .75) / 1.2549, .4, 3);
  return std::sqrt (std::min ({1.1 * lower, 1.05 * median, std::max (upper, .75 * lowest)}));
}
} // namespace

NoiseEstimate
estimateNoise (const NeighborGraph& graph, const Positions& nodes, const Execution& execution)
{
  return estimateNoise (sampleNoise (graph, nodes, execution));
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
  double sigma = sigmaBy (sample, [] (float) { return 1; });
  for (int iteration = 0; iteration < 2; ++iteration) {
    const double known = sigma * whatQuadricsFollow (sigma / spacing), usual = whatDensityHides (known / spacing);
    sigma = sigmaBy (sample, [&] (float distance) { return whatDensityHides (known / spacingOf (distance)) / usual; });
  }
  return {static_cast<float> (sigma * whatQuadricsFollow (sigma / spacing)), static_cast<float> (spacing)};
}
} // namespace core
} // namespace pcl_normal_smoothing
