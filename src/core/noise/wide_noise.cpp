// SPDX-License-Identifier: BSD-3-Clause
#include "noise_reach.h"
#include "wide_noise_of_part.h"

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
// Up to this ratio of sigma to the spacing, evenly sampled surfaces are still read and smoothed as they are.
constexpr double read_if_even = .85;
// Noise of points at random hardly shows more above half a spacing; what is read as more is of points spread evenly.
constexpr double max_first_fall = .79;
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
// Half of the points of a volume lie 1.26 times as far apart, and what quadrics leave of it grows no more; of detail it grows faster.
constexpr double max_growth_in_clumps = 1.4;
constexpr std::size_t least_to_quarter = 4 * noise_sample_size;
// Of sigma to the spacing: up to the first, where wider neighbourhoods lose detail, noise is read nearly as it is, and from the second on
// as little of it as ever; then less is lost where more than that is taken for noise.
constexpr double read_nearly = .45, read_in_part = .5;
constexpr float least_excess = 1.2f;

bool
hidesNoise (ThinnedNoiseOfCloud& noise)
{
  const double ratio = noise.ratio (0);
  const auto fallsBelow = [&] (double share, int halvings) { return noise.ratio (halvings) < share * ratio; };
  if (ratio > read_surely)
    return ratio >= read_if_even || !fallsBelow (ratio < read_of_even ? max_first_fall : max_fall, 1);
  return ratio > read_in_clumps && noise.size () >= least_to_quarter && noise.hasTurningPlanes () &&
         noise.residual (1) < max_growth_in_clumps * noise.residual (0) &&
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

/** See WideNoise::excess. */
float
excessOf (int halvings_without_loss, double ratio)
{
  const float hidden = static_cast<float> (std::clamp ((ratio - read_nearly) / (read_in_part - read_nearly), 0.0, 1.0));
  return halvings_without_loss > 0 ? WideNoise::most_excess
                                   : least_excess + (WideNoise::most_excess - least_excess) * hidden;
}

/** The same noise all over the cloud, or nearly so. */
WideNoise
wideNoiseOfCloud (ThinnedNoiseOfCloud& cloud, int to_read)
{
  const NoiseEstimate& noise = cloud.noise (to_read);
  const float sigma = sigmaOf (cloud, to_read);
  const int without_loss = halvingsWithoutLoss (cloud, to_read);
  const std::vector<LocalValue> ratios = localRatios (cloud, to_read, sigma);
  const double usual_ratio = sigma / noise.spacing * std::exp2 (.5 * to_read);
  WideNoise wide;
  wide.sigma = sigma;
  wide.field = noise.field;
  wide.excess = excessOf (without_loss, usual_ratio);
  wide.halvings = regionalMedians (halvingsToReach (without_loss, ratios, cloud.rowLength ()), noise.spacing);
  if (without_loss == 0 && usual_ratio >= least_ratio_to_project)
    wide.ratios = regionalMedians (ratios, noise.spacing);
  return wide;
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
