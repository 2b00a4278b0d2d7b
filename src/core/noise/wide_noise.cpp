// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/noise/thinned_noise.h>
#include <pcl_normal_smoothing/core/noise/wide_noise.h>
#include <pcl_normal_smoothing/core/search/hash_sample.h>
#include <pcl_normal_smoothing/core/sheets/sheet_looks.h>
#include <pcl_normal_smoothing/core/sheets/sheet_test.h>

#include <algorithm>
#include <cmath>
#include <numeric>

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

bool
hidesNoise (ThinnedNoise& noise)
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
halvingsToRead (ThinnedNoise& noise)
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
RegionalField
halvingsToReach (double sigmas, std::vector<LocalValue> ratios, std::uint32_t row_length, float spacing)
{
  const double reach = std::sqrt (row_length / M_PI); // in spacings
  for (LocalValue& local : ratios)
    local.value = static_cast<float> (std::max (0.0, 2 * std::log2 (sigmas * local.value / reach)));
  return regionalMedians (ratios, spacing);
}
} // namespace

WideNoise
estimateWideNoise (const NeighborGraph& graph, const Positions& nodes, const Execution& execution)
{
  if (graph.minRowLength () < noise_row_length)
    return {};
  const Execution still = execution.still ();
  ThinnedNoise thinned (graph, nodes, still);
  const int to_read = halvingsToRead (thinned);
  if (to_read == 0 || mayBeSheets (nodes, thinned.noise (0), still))
    return {};
  const NoiseEstimate noise = thinned.noise (to_read);
  const float sigma = sigmaOf (thinned, to_read);
  const int without_loss = halvingsWithoutLoss (thinned, to_read);
  const std::vector<LocalValue> ratios = localRatios (thinned.sample (to_read), noise, to_read, sigma);
  const double usual_ratio = sigma / noise.spacing * std::exp2 (.5 * to_read);
  const double reach = least_reach * std::pow (growth_of_reach, without_loss);
  WideNoise wide {sigma, noise.field, halvingsToReach (reach, ratios, thinned.rowLength (), noise.spacing), {}};
  if (without_loss == 0 && usual_ratio >= least_ratio_to_project)
    wide.ratios = regionalMedians (ratios, noise.spacing);
  return wide;
}
} // namespace core
} // namespace pcl_normal_smoothing
