// SPDX-License-Identifier: BSD-3-Clause
#include "ramp.h"

#include "smoothing_preparation.h"

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
// The median height of a sheet's points, cut off towards the other sheet, is too small; and sigma had better be too
// large.
constexpr float sheet_noise_factor = 1.4f;
// Noise as wide as the points are apart is estimated as .7 to .9 of what it is, .8 spacings at most. So from the first
// ratio to the spacing on sigma is assumed to be larger, from the second on by the factor; at .7 that costs nothing.
constexpr float perhaps_wide = .67f;
constexpr float as_if_wide = .74f;
constexpr float underestimated_factor = 1.6f;
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

/** The distance where no sheets are seen: above the noise everywhere. */
float
distanceOfOneSheet (const NoiseEstimate& noise)
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

/** Sets the distance of the sheets where it is to be estimated.
  * \param[in] may_be_one where none are seen, the preset fast does not look for other sheets: it costs time */
void
setSheetDistance (const NoiseEstimate& known,
                  const SheetEstimate& sheets,
                  bool may_be_one,
                  RobustSmoothingOptions& rounds)
{
  float& distance = rounds.sheet_distance;
  if (sheets.gap > 0)
    distance = std::min (sheetScales (known.sigma, known.spacing)[0].distance, share_of_gap * sheets.gap);
  else if (distance < 0)
    distance = rounds.fast && may_be_one ? std::numeric_limits<float>::infinity () : distanceOfOneSheet (known);
}

/** The estimate where the sheets were separated, from those before and after; that is nothing where too little is left
  * to tell. */
NoiseEstimate
chooseNoise (const NoiseEstimate& before, const NoiseEstimate& separated, const SheetEstimate& sheets)
{
  const float of_rows = std::min (separated.sigma, 1.2f * before.sigma), of_sheets = sheet_noise_factor * sheets.sigma;
  const float sigma = std::max (of_rows, of_sheets);
  return {sigma > 0 ? sigma : before.sigma, before.spacing, separated.spacing > 0 ? separated.field : before.field};
}

/** \return how large the noise of one sheet is assumed to be that is estimated to be so large */
NoiseEstimate
assumedNoise (NoiseEstimate estimated)
{
  const float ratio = estimated.spacing > 0 ? estimated.sigma / estimated.spacing : 0;
  estimated.sigma *= 1 + (underestimated_factor - 1) * ramp (ratio, perhaps_wide, as_if_wide - perhaps_wide);
  return estimated;
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
  const bool needs_sheets = needsSheets (options);
  NoiseEstimate noise = needsNoise (options) ? noiseBeforeSeparation () : NoiseEstimate ();
  const NoiseEstimate known = knownNoise (noise, options);
  const bool moves = known.sigma > 0;
  const SheetDetection detected =
      needs_sheets && moves ? sheets (sheetScales (known.sigma, known.spacing)) : SheetDetection ();
  const bool hides_noise = underestimatesWideNoise () && isOneSheet (detected, options);
  const auto assumed = [hides_noise] (const NoiseEstimate& estimated) {
    return hides_noise ? assumedNoise (estimated) : estimated;
  };
  setSheetDistance (knownNoise (assumed (noise), options), detected.estimate, !reachOverGaps (), options.rounds);
  if (moves)
    noise = keepToSheets (noise, detected.estimate, needs_sheets, options);
  setNoise (assumed (noise), options);
}

NoiseEstimate
SmoothingPreparation::keepToSheets (const NoiseEstimate& before,
                                    const SheetEstimate& sheets,
                                    bool may_be_layers,
                                    SmoothingOptions& options)
{
  const bool changes = separate (options) || sheets.gap > 0;
  if (!changes || !needsNoise (options))
    return before;
  const NoiseEstimate separated = separatedNoise ();
  if (!may_be_layers || !areLayers (before, separated, sheets))
    return chooseNoise (before, separated, sheets);
  undoSeparation ();
  options.rounds.sheet_distance = std::numeric_limits<float>::infinity ();
  return before;
}
} // namespace core
} // namespace pcl_normal_smoothing
