// SPDX-License-Identifier: BSD-3-Clause
#include "ramp.h"

#include <pcl_normal_smoothing/core/noise/neighborhood_widening.h>
#include <pcl_normal_smoothing/core/search/hash_sample.h>
#include <pcl_normal_smoothing/core/smoothing_preparation.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
// Beyond this many standard deviations of the noise no point has any business.
constexpr float displacement_sigmas = 5;
// Where no sheets are seen: what lies farther off is beside an edge, or on another side of a wall.
constexpr float sheet_sigmas = 4;
// Where noise varies, no more than that for the sake of its largest.
constexpr float sheet_spacings = 1.2f;
// Where it varies by more, no distance tells sheets from noise everywhere.
constexpr float most_over_sheets = 3;
// Of the way to another sheet: a point of the own one too few is better than one of the other.
constexpr float share_of_gap = .36f;
// The median height of a sheet's points, cut off towards the other sheet, is too small; and sigma had better be too large.
constexpr float sheet_noise_factor = 1.4f;
// Noise as wide as the points are apart is estimated as .7 to .9 of what it is, .8 spacings at most. So from the first
// ratio to the spacing on sigma is assumed to be larger, from the second on by the factor; at .7 that costs nothing.
constexpr float perhaps_wide = .67f;
constexpr float as_if_wide = .74f;
constexpr float underestimated_factor = 1.6f;
// Nearer than that they are layers of one wall that faces a depth camera.
constexpr float sheet_steps = 1.5f;
// Of the noise: where sheets are told apart that nobody saw, less than this is not what noise leaves.
constexpr float least_noise_left = .25f;

/** What is given counts before what is estimated. */
NoiseEstimate
knownNoise (const NoiseEstimate& estimated, const SmoothingOptions& options)
{
  const NoiseEstimate& given = options.rounds.noise;
  return {given.sigma >= 0 ? given.sigma : estimated.sigma, given.spacing >= 0 ? given.spacing : estimated.spacing,
          options.noise_varies ? estimated.field : given.field};
}

/** Where no sheets are seen: above the noise everywhere. */
float
sheetSigmas (const NoiseEstimate& noise)
{
  const float usual = sheet_sigmas * noise.sigma, largest = usual * noise.field.largestFactor ();
  const float distance = std::max (usual, std::min (largest, sheet_spacings * noise.spacing));
  return largest > most_over_sheets * distance ? std::numeric_limits<float>::infinity () : distance;
}

/** The noise has to be estimated. */
bool
needsNoise (const SmoothingOptions& options)
{
  const NoiseEstimate& noise = options.rounds.noise;
  return options.noise_varies || !(noise.sigma >= 0 && noise.spacing >= 0);
}

/** The distance of the sheets has to be estimated. */
bool
needsSheets (const SmoothingOptions& options)
{
  return options.rounds.sheet_distance < 0 && !options.rounds.oriented;
}

/** Nothing tells of a second sheet, and nobody says that there may be one. */
bool
isOneSheet (const SheetDetection& detected, const SmoothingOptions& options)
{
  return !options.rounds.oriented && !detected.may_exist &&
         (needsSheets (options) || std::isinf (options.rounds.sheet_distance));
}

/** Sets the distance of the sheets where it is to be estimated. \return whether anything will move */
bool
setSheetDistance (const NoiseEstimate& noise, const SheetEstimate& sheets, SmoothingOptions& options)
{
  const NoiseEstimate known = knownNoise (noise, options);
  float& distance = options.rounds.sheet_distance;
  if (sheets.gap > 0)
    distance = std::min (sheetScales (known.sigma, known.spacing)[0].distance, share_of_gap * sheets.gap);
  else if (distance < 0)
    distance = options.rounds.fast ? std::numeric_limits<float>::infinity () : sheetSigmas (known);
  return known.sigma > 0;
}

/** The estimate where the sheets were separated, from those before and after; that is nothing where too little is left to tell. */
NoiseEstimate
chooseNoise (const NoiseEstimate& before, const NoiseEstimate& separated, const SheetEstimate& sheets)
{
  const float of_rows = std::min (separated.sigma, 1.2f * before.sigma), of_sheets = sheet_noise_factor * sheets.sigma;
  const float sigma = std::max (of_rows, of_sheets);
  return {sigma > 0 ? sigma : before.sigma, before.spacing, separated.spacing > 0 ? separated.field : before.field};
}

/** \return how large the noise of one sheet is assumed to be that is estimated to be so large */
float
assumedSigma (const NoiseEstimate& estimated)
{
  const float ratio = estimated.spacing > 0 ? estimated.sigma / estimated.spacing : 0;
  return estimated.sigma * (1 + (underestimated_factor - 1) * ramp (ratio, perhaps_wide, as_if_wide - perhaps_wide));
}

/** Takes the noise to be larger where neighbourhoods grow with it. */
NoiseField
largerWhereWide (NoiseField field, const WideNoise& wide)
{
  for (RegionalField::Region& region : field.factors.regions)
    if (wide.halvings.valueAt (region.centre, 0) >= .5f) // from there on they grow
      region.value *= wide.excess;
  return field;
}

/** Sets whatever else is to be estimated. */
void
setNoise (const NoiseEstimate& noise, SmoothingOptions& options)
{
  RobustSmoothingOptions& rounds = options.rounds;
  rounds.noise.sigma = rounds.noise.sigma < 0 ? noise.sigma : rounds.noise.sigma;
  rounds.noise.spacing = rounds.noise.spacing < 0 ? noise.spacing : rounds.noise.spacing;
  if (std::exchange (options.noise_varies, false))
    rounds.noise.field = noise.field;
  if (!std::isfinite (rounds.max_displacement) && rounds.noise.sigma > 0)
    rounds.max_displacement = displacement_sigmas * rounds.noise.sigma * rounds.noise.field.largestFactor ();
}

/** A cloud that is seen as a whole. */
class WholeCloud : public SmoothingPreparation
{
public:
  /** \param[in,out] positions kept, as everything else, while this is used */
  WholeCloud (Positions& positions, const Vectors& normals, const Execution& execution, NeighborGraph::ConstPtr& graph)
  : positions_ (positions), normals_ (normals), execution_ (execution), graph_ (graph), unseparated_ (graph)
  {}

  /** \param[in] may_project false: points without a normal may not move, and opposite normals tell sheets apart
    * \return whether neighbourhoods had to grow, or points to be projected */
  bool
  widen (bool may_project)
  {
    widening_ = estimateWidening (*unseparated_, positions_, execution_);
    if (!may_project)
      widening_.wide_noise.ratios = {};
    if (const auto wide = widenNeighborhoods (*unseparated_, positions_, widening_, execution_))
      graph_ = unseparated_ = wide;
    else if (const auto projected = projectNodes (*unseparated_, widening_, execution_, positions_))
      graph_ = unseparated_ = projected;
    else
      widening_ = widening_.roundingAlone ();
    return widening_.isNeeded ();
  }

protected:
  NoiseEstimate
  noiseBeforeSeparation () override
  {
    return noiseOf (sampleNoise (*graph_, positions_, execution_));
  }

  SheetDetection
  sheets (const SheetScales& scales) override
  {
    const std::vector<std::uint32_t> sample = sampleNodes (positions_, sheet_sample_size, execution_);
    const SheetDetection detected = detectSheets (*graph_, positions_, sample, scales, execution_);
    return detected.estimate.gap < sheet_steps * largestStep () ? SheetDetection () : detected;
  }

  bool
  separate (const SmoothingOptions& options) override
  {
    const SheetSeparationOptions by = separation (options, normals_);
    if (separationDepth (by) < 0)
      return false;
    graph_ = separateSheets (unseparated_, positions_, by, execution_);
    return graph_ != unseparated_ || unseparated_->minRowLength () < noise_row_length;
  }

  NoiseEstimate
  separatedNoise () override
  {
    const std::size_t size = graph_->finiteCount ();
    const std::vector<std::uint32_t> sample = sampleNodes (positions_, noise_sample_size, execution_);
    return noiseOf (sampleNoise (*graph_, positions_, sample, size, execution_));
  }

  void
  undoSeparation () override
  {
    graph_ = unseparated_;
  }

  bool
  underestimatesWideNoise () const override
  {
    return !widening_.isNeeded () && !(widening_.rounding.step > 0);
  }

private:
  NoiseEstimate
  noiseOf (const NoiseSample& sample) const
  {
    NoiseEstimate noise = estimateNoise (sample, widening_);
    const WideNoise& wide = widening_.wide_noise;
    if (!wide.is_everywhere)
      noise.field = largerWhereWide (noise.field, wide);
    else if (wide.sigma > 0 && !widening_.projects ())
      noise.sigma *= wide.excess;
    return noise;
  }

  /** From one layer to the next, or of coordinates; 0 where there is none. */
  float
  largestStep () const
  {
    const std::vector<float> steps = widening_.layers.steps.values ();
    return std::max (widening_.rounding.step, steps.empty () ? 0 : *std::max_element (steps.begin (), steps.end ()));
  }

  Positions& positions_;
  const Vectors& normals_;
  const Execution& execution_;
  NeighborGraph::ConstPtr& graph_;
  NeighborGraph::ConstPtr unseparated_; // before sheets were separated
  Widening widening_;                   // of unseparated_
};
} // namespace

SheetSeparationOptions
SmoothingPreparation::separation (const SmoothingOptions& options, const Vectors& normals)
{
  return {options.rounds.sheet_distance, options.rounds.oriented ? &normals : nullptr};
}

bool
SmoothingPreparation::areLayers (const NoiseEstimate& before,
                                 const NoiseEstimate& separated,
                                 const SheetEstimate& sheets)
{
  return !(sheets.gap > 0) && separated.spacing > 0 && separated.sigma < least_noise_left * before.sigma;
}

void
SmoothingPreparation::complete (SmoothingOptions& options)
{
  if (!options.robust)
    return;
  const bool needs_noise = needsNoise (options), needs_sheets = needsSheets (options);
  NoiseEstimate noise = needs_noise ? noiseBeforeSeparation () : NoiseEstimate ();
  const NoiseEstimate known = knownNoise (noise, options);
  const SheetDetection detected =
      needs_sheets && known.sigma > 0 ? sheets (sheetScales (known.sigma, known.spacing)) : SheetDetection ();
  const bool hides_noise = underestimatesWideNoise () && isOneSheet (detected, options);
  const auto assumed = [&] (NoiseEstimate estimated) {
    estimated.sigma = hides_noise ? assumedSigma (estimated) : estimated.sigma;
    return estimated;
  };
  const bool moves = setSheetDistance (assumed (noise), detected.estimate, options);
  const bool changes = moves && separate (options);
  if (needs_noise && moves && (changes || detected.estimate.gap > 0))
    noise = noiseOfSheets (noise, detected.estimate, needs_sheets, options);
  setNoise (assumed (noise), options);
}

NoiseEstimate
SmoothingPreparation::noiseOfSheets (const NoiseEstimate& before,
                                     const SheetEstimate& sheets,
                                     bool may_be_layers,
                                     SmoothingOptions& options)
{
  const NoiseEstimate separated = separatedNoise ();
  if (!may_be_layers || !areLayers (before, separated, sheets))
    return chooseNoise (before, separated, sheets);
  undoSeparation ();
  options.rounds.sheet_distance = std::numeric_limits<float>::infinity ();
  return before;
}

void
prepareSmoothing (const Vectors& normals,
                  const Execution& execution,
                  NeighborGraph::ConstPtr& graph,
                  SmoothingOptions& options,
                  Positions& positions)
{
  WholeCloud cloud (positions, normals, execution, graph);
  const bool moves = options.robust && options.rounds.rounds > 0 && options.rounds.noise.sigma != 0;
  const bool may_project = options.normals != NormalSource::INPUT;
  options.widen_neighborhoods = moves && options.widen_neighborhoods && cloud.widen (may_project);
  cloud.complete (options);
}
} // namespace core
} // namespace pcl_normal_smoothing
