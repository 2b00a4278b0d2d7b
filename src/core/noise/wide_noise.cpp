// SPDX-License-Identifier: BSD-3-Clause
#include "noise_reach.h"
#include "residual_quantiles.h"
#include "wide_noise_of_part.h"

#include "../search/hash_sample.h"
#include "../sheets/sheet_criterion.h"
#include "../sheets/sheet_detection.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
// Ratios are of the estimated sigma to the spacing; drops are of the ratio in a halved cloud to that before: see
// noise_reach.h.

// Up to this ratio evenly sampled surfaces show noise well enough to be smoothed as they are. Beyond, the ratio no
// longer grows with the noise, which is hidden whatever the drop.
constexpr double saturated_ratio = .85;
// Points at random places hardly ever show more than half a spacing, however large the noise: a ratio above this means
// evenly spread points. Below it, the first halving must drop the ratio further.
constexpr double random_sampling_ratio = .67;
constexpr double resolved_drop_first = .79;
// A drop that suffices for the halving that first resolves the noise, whatever the next one shows: sheets farther apart
// may raise the ratio again.
constexpr double resolved_drop_at_once = .75;
// The thinnest cloud cannot be halved once more to see the ratio drop. It shows a surface if its ratio is below the first
// of these, or the mean ratio of the two thinnest clouds below the second, or cloudThickness below the third: a volume,
// such as leaves or grass, exceeds all three.
constexpr double resolved_ratio_of_last = .32, resolved_ratio_of_last_two = .335;
constexpr double max_thickness = .45;
// Where points lie in clumps, as where sweeps of a lidar cross, these hide the noise, while the usual spacing is that
// of other places: so the ratio may be as small as this. There, planes through few points differ from those through
// more, and the ratio hardly drops by one halving or by two. Detail in small clouds does the same, so a quarter of the
// cloud must still be a whole sample.
constexpr double clumped_ratio = .1;
constexpr double resolved_drop_in_clumps = .92, resolved_drop_of_two = .7;
// Half the points of a volume lie 1.26 times as far apart, and its residuals grow no more than that; those of detail
// grow faster.
constexpr double max_growth_in_clumps = 1.4;
constexpr std::size_t least_to_quarter = 4 * noise_sample_size;
// Where all points lie in clumps, as in the frames of a camera that stands still, the 16 nearest reach beyond a clump:
// their residuals grow little, and not at all once the noise is resolved. Sigma then stays the same too, and is larger
// than in the whole cloud.
constexpr double max_growth_of_clumps = 2, max_growth_resolved = 1.05;
constexpr double min_gain_of_sigma = 1.5, max_gain_resolved = 1.15;
// And residuals differ from place to place as for even noise: see ThinnedNoise::spread.
constexpr double min_spread = .96 * quartile_ratio_of_16, max_spread = 1.13 * quartile_ratio_of_16;

bool
hidesNoise (ThinnedNoise& noise)
{
  const double ratio = noise.ratio (0);
  const auto dropsBelow = [&] (double share, int halvings) { return noise.ratio (halvings) < share * ratio; };
  if (ratio > resolved_ratio)
    return ratio >= saturated_ratio ||
           !dropsBelow (ratio < random_sampling_ratio ? resolved_drop_first : resolved_drop, 1);
  return ratio > clumped_ratio && noise.size () >= least_to_quarter && noise.hasTurningPlanes () &&
         noise.residual (1) < max_growth_in_clumps * noise.residual (0) &&
         (!dropsBelow (resolved_drop_in_clumps, 1) || !dropsBelow (resolved_drop_of_two, 2));
}

bool
showsOneNoise (ThinnedNoise& noise, int halvings)
{
  return noise.spread (halvings) > min_spread && noise.spread (halvings) < max_spread;
}

/** halvingsToResolve where all points lie in clumps. */
int
halvingsToResolveClumps (ThinnedNoise& noise)
{
  const auto gain = [&] (int from, int to) { return noise.noise (to).sigma / noise.noise (from).sigma; };
  const auto growth = [&] (int from, int to) { return noise.residual (to) / noise.residual (from); };
  if (noise.ratio (0) > resolved_ratio || !noise.hasTurningPlanes () || !(growth (0, 1) < max_growth_in_clumps))
    return 0;
  for (int halvings = 1; halvings < noise.mostHalvings () && growth (0, halvings) < max_growth_of_clumps; ++halvings)
    if (noise.ratio (halvings) < resolved_ratio && growth (halvings, halvings + 1) < max_growth_resolved &&
        gain (halvings, halvings + 1) < max_gain_resolved && gain (0, halvings) > min_gain_of_sigma &&
        showsOneNoise (noise, halvings))
      return halvings;
  return 0;
}

/** \return number of halvings of the whole cloud that resolve its noise; 0 if none is needed, or if no number shows
  * a surface: leaves and grass stay as they are */
int
halvingsToResolve (ThinnedNoise& noise)
{
  const int most = noise.mostHalvings ();
  if (most == 0)
    return 0;
  if (!hidesNoise (noise))
    return halvingsToResolveClumps (noise);
  const auto drop = [&] (int halvings) { return noise.ratio (halvings) / noise.ratio (halvings - 1); };
  for (int halvings = 1; halvings < most; ++halvings) {
    const bool at_once = noise.ratio (halvings - 1) >= resolved_ratio && drop (halvings) < resolved_drop_at_once;
    if (noise.ratio (halvings) < resolved_ratio && (at_once || drop (halvings + 1) < resolved_drop))
      return halvings;
  }
  const double last = noise.ratio (most), last_two = .5 * (last + noise.ratio (most - 1));
  if (noise.ratio (0) <= resolved_ratio || !(last > 0)) // 0: too few distinct points are left
    return 0;
  return last < resolved_ratio_of_last || last_two < resolved_ratio_of_last_two || noise.thickness () < max_thickness
             ? most
             : 0;
}

/** Detects sheets with 32 neighbours, whatever the rows of the graph. */
SheetDetection
detectSheets (const Positions& cloud, const NoiseEstimate& noise, const Execution& execution)
{
  const std::vector<std::uint32_t> nodes = sampleNodes (cloud, sheet_sample_size, execution);
  const Elements start (nodes.begin (), nodes.end ());
  const auto graph = NeighborGraph::buildAround (cloud, start, sheet_sample_depth, {sheet_row_length}, execution);
  std::vector<std::uint32_t> sample (start.size ());
  std::iota (sample.begin (), sample.end (), 0);
  return detectSheets (*graph, gather (cloud, graph->order ()), sample, sheetScales (noise.sigma, noise.spacing),
                       execution);
}

/** Close sheets look like wide noise. So do clumps inside the noise, but these do not show two peaks, and show
  * even noise when thin enough. */
bool
mayBeSheets (ThinnedNoise& cloud, int to_resolve, const SheetDetection& sheets)
{
  const bool are_clumps = to_resolve > 0 && cloud.ratio (0) <= resolved_ratio && showsOneNoise (cloud, to_resolve);
  return sheets.estimate.gap > 0 || (sheets.may_exist && !are_clumps);
}

/** The same noise all over the cloud, or nearly so. */
WideNoise
wideNoiseOfCloud (ThinnedNoise& cloud, int to_resolve)
{
  const NoiseEstimate& noise = cloud.noise (to_resolve);
  const float sigma = sigmaOf (cloud, to_resolve);
  const int without_loss = halvingsWithoutLoss (cloud, to_resolve);
  const std::vector<LocalValue> ratios = localRatios (cloud, to_resolve, sigma);
  const double usual_ratio = sigma / noise.spacing * std::exp2 (.5 * to_resolve);
  WideNoise wide;
  wide.sigma = sigma;
  wide.field = noise.field;
  wide.excess = without_loss > 0 ? WideNoise::most_excess : WideNoise::least_excess;
  wide.halvings = regionalMedians (halvingsToReach (without_loss, ratios, cloud.rowLength ()), noise.spacing);
  if (without_loss == 0 && usual_ratio >= least_ratio_to_project)
    wide.ratios = regionalMedians (ratios, noise.spacing);
  return wide;
}
/** If the noise varies, halvings that resolve that of the whole cloud are too many in some places and too few in
  * others. But for clumps only the whole cloud shows it. */
WideNoise
wideNoiseOf (ThinnedNoise& cloud, int to_resolve, const Execution& execution)
{
  if (to_resolve > 0 && (cloud.noise (to_resolve).field.isEven () || cloud.ratio (0) <= resolved_ratio))
    return wideNoiseOfCloud (cloud, to_resolve);
  const WideNoise of_part = wideNoiseOfPart (cloud, execution);
  return to_resolve > 0 && !(of_part.sigma > 0) ? wideNoiseOfCloud (cloud, to_resolve) : of_part;
}
} // namespace

WideNoise
estimateWideNoise (const NeighborGraph& graph, const Positions& nodes, const Execution& execution)
{
  if (graph.minRowLength () < noise_row_length)
    return {};
  const Execution still = execution.still ();
  ThinnedNoise cloud (graph, nodes, still);
  const int to_resolve = halvingsToResolve (cloud);
  const WideNoise wide = wideNoiseOf (cloud, to_resolve, still);
  return wide.sigma > 0 && mayBeSheets (cloud, to_resolve, detectSheets (nodes, cloud.noise (0), still)) ? WideNoise ()
                                                                                                         : wide;
}
} // namespace core
} // namespace pcl_normal_smoothing
