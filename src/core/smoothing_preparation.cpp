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
// Upper bound on the displacement of a point, in standard deviations of the noise.
constexpr float displacement_sigmas = 5;
// If the largest noise exceeds the distance by more than this factor, no distance separates sheets from noise
// everywhere: it is infinite.
constexpr float most_over_sheets = 3;
// As a share of the gap; rather lose a point of the same sheet than keep one of the other.
constexpr float share_of_gap = .36f;
// The median height is cut off towards the other sheet, so it is too small; overestimating sigma does less harm.
constexpr float sheet_noise_factor = 1.4f;
// Upper bound on the noise in rows without other sheets, over that before they were separated.
constexpr float most_over_unseparated = 1.2f;
// Noise about as wide as the spacing is read too small: as .7 to .9 of its sigma, and never as more than .8 spacings.
// So sigma is multiplied: by 1 where sigma over the spacing is up to perhaps_wide, by underestimated_factor from
// as_if_wide on, and linearly in between. A true .7 is raised too, and is smoothed no worse.
constexpr float perhaps_wide = .67f;
constexpr float as_if_wide = .74f;
constexpr float underestimated_factor = 1.6f;
// If separating sheets that no test saw leaves less than this share of the noise, they were layers, not sheets.
constexpr float least_noise_left = .25f;

/** Given values take precedence over estimated ones. */
NoiseEstimate
knownNoise (const NoiseEstimate& estimated, const SmoothingOptions& options)
{
  const NoiseEstimate& given = options.rounds.noise;
  return {given.sigma >= 0 ? given.sigma : estimated.sigma, given.spacing >= 0 ? given.spacing : estimated.spacing,
          options.noise_varies ? estimated.field : given.field};
}

/** The sheet distance if no sheets are seen: above the noise everywhere, for farther points are beyond an edge, or on
  * another side of a wall. */
float
distanceOfOneSheet (const NoiseEstimate& noise)
{
  const float usual = sheet_sigmas * noise.sigma, largest = usual * noise.field.largestFactor ();
  const float distance = std::max (usual, std::min (largest, most_sheet_spacings * noise.spacing));
  return largest > most_over_sheets * distance ? std::numeric_limits<float>::infinity () : distance;
}

/** Whether the noise has to be estimated. */
bool
needsNoise (const SmoothingOptions& options)
{
  const NoiseEstimate& noise = options.rounds.noise;
  return options.noise_varies || !(noise.sigma >= 0 && noise.spacing >= 0);
}

/** Whether the sheet distance has to be estimated. */
bool
needsSheets (const SmoothingOptions& options)
{
  return options.rounds.sheet_distance < 0 && !options.rounds.oriented;
}

/** Whether no second sheet is seen, and the options do not say that there may be one. */
bool
isOneSheet (const SheetDetection& detected, const SmoothingOptions& options)
{
  return !options.rounds.oriented && !detected.may_exist &&
         (needsSheets (options) || std::isinf (options.rounds.sheet_distance));
}

/** Sets the sheet distance if it is to be estimated.
  * \param[in] may_be_one if no sheets are seen, the preset fast does not look for any, which saves time */
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

/** The noise after sheets were separated, from the estimates before and after; the latter is empty if too few points
  * are left. */
NoiseEstimate
chooseNoise (const NoiseEstimate& before, const NoiseEstimate& separated, const SheetEstimate& sheets)
{
  const float of_rows = std::min (separated.sigma, most_over_unseparated * before.sigma),
              of_sheets = sheet_noise_factor * sheets.sigma;
  const float sigma = std::max (of_rows, of_sheets);
  return {sigma > 0 ? sigma : before.sigma, before.spacing, separated.spacing > 0 ? separated.field : before.field};
}

/** Raises the estimated noise of a single sheet where it is likely to be underestimated. */
NoiseEstimate
assumedNoise (NoiseEstimate estimated)
{
  const float ratio = estimated.spacing > 0 ? estimated.sigma / estimated.spacing : 0;
  estimated.sigma *= 1 + (underestimated_factor - 1) * ramp (ratio, perhaps_wide, as_if_wide - perhaps_wide);
  return estimated;
}

/** Sets everything else that is to be estimated. */
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
  if (!options.in_rounds)
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
