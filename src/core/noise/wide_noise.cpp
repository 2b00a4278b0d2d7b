// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/noise/thinned_noise.h>
#include <pcl_normal_smoothing/core/noise/wide_noise.h>
#include <pcl_normal_smoothing/core/quantile.h>
#include <pcl_normal_smoothing/core/search/hash_sample.h>
#include <pcl_normal_smoothing/core/sheets/sheet_looks.h>
#include <pcl_normal_smoothing/core/sheets/sheet_test.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
// Of sigma to the spacing, as they are read. Up to the first, nothing is hidden but in clumps (below), and neighbourhoods that have to be
// wider had better be that wide; up to the second, evenly sampled surfaces are still read and smoothed as they are.
constexpr double read_surely = .3;
constexpr double read_if_even = .85;
// A halving makes the spacing 1.4 times as wide, and the ratio .71 of what it was, two halvings .5; where a part of the noise is hidden,
// more of it shows. That of points at random hardly does above half a spacing; what is read as more is of points spread evenly.
constexpr double max_fall = .83, max_first_fall = .79;
constexpr double read_of_even = .67;
constexpr double max_fall_of_two = .7;
// All of it in one halving: of sheets farther apart the next one may show more again.
constexpr double max_fall_at_once = .75;
// The thinnest cloud has too few points to show the ratio fall, but that of a volume is larger; or wide parts are thicker.
constexpr double read_at_last = .32, read_by_last_two = .335;
constexpr double max_thickness = .45;
// Where points lie in clumps, as where sweeps of a lidar cross, noise hides in these, and the usual spacing is that of others: less is read.
// There planes through few points are not those through more, and the ratio hardly falls. In small clouds detail does the same; so
// a quarter of the cloud has to be a whole sample.
constexpr double read_in_clumps = .1;
constexpr double max_fall_in_clumps = .92;
constexpr std::size_t least_to_quarter = 4 * noise_sample_size;
constexpr double spacing_of_reach = .6267; // of the eighth point, as in the estimate of the noise: sqrt (pi / 8)
// To the farthest neighbour, in sigmas: narrower neighbourhoods are lost in the noise. Every halving beyond that which shows the noise makes
// them wider by the second, where nothing is lost by it: a quadric that misses a third of sigma in detail leaves 1.05 times as much.
// Maps with clumps are of rooms and streets.
constexpr double least_reach = 4.25;
constexpr double growth_of_reach = 1.58;
constexpr int most_halvings_without_loss = 2;
constexpr double max_growth = 1.05;
// Where the noise is wide in a part of the cloud only. From one halving to four, neighbourhoods become 2.8 times as wide.
constexpr int few_halvings = 1, more_halvings = 4;
constexpr float min_shown_ratio = .3f;
constexpr float growth_of_wide = 1.3f, growth_near_wide = 1.2f;
constexpr std::size_t least_part = 64; // of the sample
constexpr double min_growth_in_part = 1.4;
constexpr double max_spread_in_part = 1.2;

bool
hidesNoise (ThinnedNoiseOfCloud& noise)
{
  const double ratio = noise.ratio (0);
  const auto fallsBelow = [&] (double share, int halvings) { return noise.ratio (halvings) < share * ratio; };
  if (ratio > read_surely)
    return ratio >= read_if_even || !fallsBelow (ratio < read_of_even ? max_first_fall : max_fall, 1);
  return ratio > read_in_clumps && noise.size () >= least_to_quarter && noise.hasTurningPlanes () &&
         (!fallsBelow (max_fall_in_clumps, 1) || !fallsBelow (max_fall_of_two, 2));
}

/** \return how often the cloud has to be halved, as a whole, for its noise to be read; 0 where it need not be, or where no surface is seen
  * however often: leaves and grass stay as they are */
int
halvingsToRead (ThinnedNoiseOfCloud& noise)
{
  const int most = noise.mostHalvings ();
  if (most == 0 || !hidesNoise (noise))
    return 0;
  const auto fall = [&] (int halvings) { return noise.ratio (halvings) / noise.ratio (halvings - 1); };
  for (int halvings = 1; halvings < most; ++halvings) {
    const bool is_read_at_once = noise.ratio (halvings - 1) >= read_surely && fall (halvings) < max_fall_at_once;
    if (noise.ratio (halvings) < read_surely && (is_read_at_once || fall (halvings + 1) < max_fall))
      return halvings;
  }
  const double last = noise.ratio (most), last_two = .5 * (last + noise.ratio (most - 1));
  if (noise.ratio (0) <= read_surely || !(last > 0)) // 0: too few distinct points are left
    return 0;
  return last < read_at_last || last_two < read_by_last_two || noise.thickness () < max_thickness ? most : 0;
}

/** Up to where it is read it is hidden in part; and there, the thinner the cloud the more do quadrics miss for the sake of detail.
  * \return the most that is seen */
float
sigmaOf (ThinnedNoise& noise, int halvings_to_read)
{
  float sigma = 0;
  for (int halvings = 0; halvings <= halvings_to_read; ++halvings)
    sigma = std::max (sigma, noise.noise (halvings).sigma);
  return sigma;
}

/** \return how often the cloud can be halved beyond that which shows the noise, and nothing is lost by neighbourhoods that grow with it */
int
halvingsWithoutLoss (ThinnedNoise& noise, int halvings_to_read)
{
  if (noise.ratio (0) <= read_surely) // in clumps
    return most_halvings_without_loss;
  const double all = max_growth * noise.residual (halvings_to_read);
  int halvings = halvings_to_read;
  while (halvings < std::min (noise.mostHalvings (), halvings_to_read + most_halvings_without_loss) &&
         noise.residual (halvings + 1) <= all)
    ++halvings;
  return halvings - halvings_to_read;
}

/** Close sheets look like wide noise. Seen with 32 neighbours, whatever the rows of the graph. */
bool
mayBeSheets (const Positions& cloud, const NoiseEstimate& noise, const Execution& execution)
{
  const std::vector<std::uint32_t> nodes = sampleNodes (cloud, sheet_sample_size, execution);
  const Elements start (nodes.begin (), nodes.end ());
  const auto graph = NeighborGraph::buildAround (cloud, start, sheet_sample_depth, {sheet_row_length}, execution);
  std::vector<std::uint32_t> sample (start.size ());
  std::iota (sample.begin (), sample.end (), 0);
  return lookForSheets (*graph, gather (cloud, graph->order ()), sample, sheetLooks (noise.sigma, noise.spacing),
                        execution)
      .may_be;
}

/** sigma over the spacing of the whole cloud, by regions. \param[in] shown by a cloud that was halved so often, where \a sigma is usual */
std::vector<LocalValue>
localRatios (const NoiseSample& shown, const NoiseEstimate& noise, int halvings, float sigma)
{
  std::vector<LocalValue> ratios;
  for (const NoiseSample::Residuals& residuals : shown.of_nodes) {
    const double spacing = std::max<double> (spacing_of_reach * residuals.distance, 1e-3 * noise.spacing);
    const double ratio = sigma * noise.field.factorAt (residuals.place) / spacing * std::exp2 (.5 * halvings);
    ratios.push_back ({residuals.place, static_cast<float> (ratio)});
  }
  return ratios;
}

/** How often the cloud has to be halved for rows of that length to reach so many sigmas. */
std::vector<LocalValue>
halvingsToReach (double sigmas, std::vector<LocalValue> ratios, std::uint32_t row_length)
{
  const double reach = std::sqrt (row_length / M_PI); // in spacings
  for (LocalValue& local : ratios)
    local.value = static_cast<float> (std::max (0.0, 2 * std::log2 (sigmas * local.value / reach)));
  return ratios;
}

/** The same noise all over the cloud, or nearly so. */
WideNoise
wideNoiseOfCloud (ThinnedNoiseOfCloud& cloud, int to_read)
{
  const NoiseEstimate& noise = cloud.noise (to_read);
  const float sigma = sigmaOf (cloud, to_read);
  const int without_loss = halvingsWithoutLoss (cloud, to_read);
  const std::vector<LocalValue> ratios = localRatios (cloud.sample (to_read), noise, to_read, sigma);
  const double usual_ratio = sigma / noise.spacing * std::exp2 (.5 * to_read);
  const double reach = least_reach * std::pow (growth_of_reach, without_loss);
  WideNoise wide;
  wide.sigma = sigma;
  wide.field = noise.field;
  wide.halvings = regionalMedians (halvingsToReach (reach, ratios, cloud.rowLength ()), noise.spacing);
  if (without_loss == 0 && usual_ratio >= least_ratio_to_project)
    wide.ratios = regionalMedians (ratios, noise.spacing);
  return wide;
}

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

/** How much more noise the nearest points show where more halvings thin the cloud, by regions: 1 where it is read in full, or is small
  * against their spacing. Without regions where it is so everywhere. */
RegionalField
growthOfNoise (ThinnedNoise& cloud)
{
  const auto sigma = [&cloud] (int halvings, std::size_t s) {
    const std::vector<NoiseSample::Residuals>& of_nodes = cloud.sample (halvings).of_nodes;
    return s < of_nodes.size () ? std::sqrt (of_nodes[s].variances.front ()) : std::numeric_limits<float>::quiet_NaN ();
  };
  const RegionalField ratios = regionalNumbers (cloud, [&] (std::size_t s) {
    return sigma (0, s) / (static_cast<float> (spacing_of_reach) * cloud.sample (0).of_nodes[s].distance);
  });
  const auto is_small = [] (const RegionalField::Region& region) { return region.value < min_shown_ratio; };
  if (std::all_of (ratios.regions.begin (), ratios.regions.end (), is_small))
    return {};
  RegionalField growth =
      regionalNumbers (cloud, [&] (std::size_t s) { return sigma (more_halvings, s) / sigma (few_halvings, s); });
  for (RegionalField::Region& region : growth.regions)
    if (ratios.valueAt (region.centre, 0) < min_shown_ratio)
      region.value = 1;
  return growth;
}

/** How far the quartiles of what quadrics leave are apart, as a ratio of sigmas: 1 of one noise, more of detail. */
double
spreadOf (const NoiseSample& sample)
{
  constexpr double of_noise = 2.27; // of chi-square by 6 degrees of freedom, as twelve points have
  std::vector<float> variances;
  for (const NoiseSample::Residuals& residuals : sample.of_nodes)
    if (std::isfinite (residuals.variances[1]) && residuals.distance > 0)
      variances.push_back (residuals.variances[1] / (residuals.distance * residuals.distance));
  return std::sqrt (quantile (variances, .75) / (of_noise * quantile (variances, .25)));
}

/** Whether a part of the cloud hides noise, of which its regions show more and more as it is thinned. Detail does, too, but is not the
  * same all over it. */
bool
hidesNoiseInPart (ThinnedNoise& part)
{
  if (part.sample (0).of_nodes.size () < least_part || !(part.ratio (0) > read_surely))
    return false;
  const double growth =
      part.ratio (more_halvings) / part.ratio (few_halvings) * std::exp2 (.5 * (more_halvings - few_halvings));
  return growth > min_growth_in_part && spreadOf (part.sample (0)) < max_spread_in_part;
}

/** \return how often the cloud has to be halved for the noise of a part to be read that hides it; 0: there is no surface */
int
halvingsToReadPart (ThinnedNoise& part)
{
  for (int halvings = 1; halvings < part.mostHalvings (); ++halvings)
    if (part.ratio (halvings) < read_surely && part.ratio (halvings + 1) < max_fall * part.ratio (halvings))
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

/** Where the noise is wide in a part of the cloud only: that of depth cameras grows as the square of the distance, the spacing as
  * the distance. \return sigma 0 where it is so nowhere */
WideNoise
wideNoiseOfPart (ThinnedNoiseOfCloud& cloud)
{
  const NoiseEstimate& read = cloud.noise (0);
  if (!(read.spacing > 0) || cloud.mostHalvings () < more_halvings)
    return {};
  const RegionalField growth = growthOfNoise (cloud);
  constexpr float infinity = std::numeric_limits<float>::infinity ();
  ThinnedNoiseOfPart core (cloud, growth, growth_of_wide, infinity), wide (cloud, growth, growth_near_wide, infinity),
      other (cloud, growth, -1, growth_near_wide);
  const int to_read = hidesNoiseInPart (core) ? halvingsToReadPart (core) : 0;
  if (to_read == 0)
    return {};
  const float sigma = sigmaOf (wide, to_read);
  const double reach = least_reach * std::pow (growth_of_reach, halvingsWithoutLoss (wide, to_read));
  const NoiseField& field = wide.noise (to_read).field;
  std::vector<LocalValue> halvings =
      halvingsToReach (reach, localRatios (wide.sample (to_read), wide.noise (to_read), to_read, sigma),
                       cloud.rowLength ());
  std::vector<LocalValue> sigmas = localSigmas (wide.sample (to_read), field, sigma);
  for (const LocalValue& local : localSigmas (other.sample (0), read.field, read.sigma)) {
    sigmas.push_back (local);
    halvings.push_back ({local.place, 0});
  }
  std::vector<float> values;
  for (const LocalValue& local : sigmas)
    values.push_back (local.value);
  WideNoise noise;
  noise.sigma = quantile (values, .5);
  noise.field = relativeField (regionalMedians (sigmas, read.spacing), noise.sigma);
  noise.halvings = regionalMedians (halvings, read.spacing);
  noise.is_everywhere = false;
  return noise;
}
} // namespace

WideNoise
estimateWideNoise (const NeighborGraph& graph, const Positions& nodes, const Execution& execution)
{
  if (graph.minRowLength () < noise_row_length)
    return {};
  const Execution still = execution.still ();
  ThinnedNoiseOfCloud cloud (graph, nodes, still);
  const int to_read = halvingsToRead (cloud);
  const WideNoise wide = to_read > 0 ? wideNoiseOfCloud (cloud, to_read) : wideNoiseOfPart (cloud);
  return wide.sigma > 0 && mayBeSheets (nodes, cloud.noise (0), still) ? WideNoise () : wide;
}
} // namespace core
} // namespace pcl_normal_smoothing
