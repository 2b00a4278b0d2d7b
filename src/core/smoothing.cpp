// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/error.h>
#include <pcl_normal_smoothing/core/smoothing.h>

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
// Two points of one sheet hardly lie farther apart across it.
constexpr float sheet_sigmas = 4;
// Sheets are told apart where they are more than a spacing or so apart, however large the noise seems for their sake.
constexpr float test_spacings = 1.2f;
// Of the way to another sheet: a point of the own one too few is better than one of the other.
constexpr float share_of_gap = .36f;
// The median height of a sheet's points, cut off towards the other sheet, is too small; and sigma had better be too large.
constexpr float sheet_noise_factor = 1.4f;
// Of the noise: where sheets are told apart that nobody saw, less than this is not what noise leaves.
constexpr float noise_of_layers = .25f;

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
  return std::max (usual, std::min (largest, test_spacings * noise.spacing));
}
} // namespace

SmoothingOptions
SmoothingOptions::inUnit (double unit) const
{
  const auto convert = [unit] (float& length) { length = length < 0 ? length : static_cast<float> (length / unit); };
  SmoothingOptions options = *this;
  options.update = update.inUnit (unit);
  convert (options.rounds.max_displacement);
  convert (options.rounds.noise.sigma);
  convert (options.rounds.noise.spacing);
  options.rounds.noise.field = rounds.noise.field.inUnit (unit);
  convert (options.rounds.sheet_distance);
  return options;
}

void
check (const SmoothingOptions& options)
{
  check (options.filter);
  check (options.update);
  const bool oriented = options.filter.oriented || options.update.oriented || options.rounds.oriented;
  if (oriented && options.normals != NormalSource::INPUT)
    throw Error ("the normals are called oriented, but those that are estimated have arbitrary signs: "
                 "read oriented ones from the input (NormalSource::INPUT), or do not call them oriented");
  RobustSmoothingOptions rounds = options.rounds;
  rounds.noise.sigma = std::max (rounds.noise.sigma, 0.0f); // below 0 means that it is to be estimated
  rounds.noise.spacing = std::max (rounds.noise.spacing, 0.0f);
  rounds.sheet_distance = std::max (rounds.sheet_distance, 0.0f);
  if (options.robust)
    check (rounds);
}

bool
SmoothingPreparation::needsNoise (const SmoothingOptions& options)
{
  const NoiseEstimate& noise = options.rounds.noise;
  return options.robust && (options.noise_varies || !(noise.sigma >= 0 && noise.spacing >= 0));
}

float
SmoothingPreparation::sheetTestDistance (const NoiseEstimate& noise, const SmoothingOptions& options)
{
  const NoiseEstimate known = knownNoise (noise, options);
  if (!options.robust || options.rounds.oriented || options.rounds.sheet_distance >= 0 || !(known.sigma > 0))
    return std::numeric_limits<float>::infinity ();
  return std::min (sheet_sigmas * known.sigma, test_spacings * known.spacing);
}

bool
SmoothingPreparation::setSheetDistance (const NoiseEstimate& noise,
                                        const SheetEstimate& sheets,
                                        SmoothingOptions& options)
{
  const NoiseEstimate known = knownNoise (noise, options);
  float& distance = options.rounds.sheet_distance;
  if (sheets.gap > 0)
    distance = std::min (sheetTestDistance (noise, options), share_of_gap * sheets.gap);
  else if (distance < 0)
    distance = sheetSigmas (known);
  return options.robust && known.sigma > 0; // else nothing moves
}

SheetSeparationOptions
SmoothingPreparation::separation (const SmoothingOptions& options, const Vectors& normals)
{
  return {options.rounds.sheet_distance, options.rounds.oriented ? &normals : nullptr};
}

NoiseEstimate
SmoothingPreparation::chooseNoise (const NoiseEstimate& mixed,
                                   const NoiseEstimate& separated,
                                   const SheetEstimate& sheets)
{
  const float of_rows = std::min (separated.sigma, 1.2f * mixed.sigma), of_sheets = sheet_noise_factor * sheets.sigma;
  const float sigma = std::max (of_rows, of_sheets);
  return {sigma > 0 ? sigma : mixed.sigma, mixed.spacing, separated.field};
}

bool
SmoothingPreparation::areLayers (const NoiseEstimate& mixed,
                                 const NoiseEstimate& separated,
                                 const SheetEstimate& sheets)
{
  return !(sheets.gap > 0) && separated.spacing > 0 && separated.sigma < noise_of_layers * mixed.sigma;
}

void
SmoothingPreparation::setNoise (const NoiseEstimate& noise, SmoothingOptions& options)
{
  RobustSmoothingOptions& rounds = options.rounds;
  rounds.noise.sigma = rounds.noise.sigma < 0 ? noise.sigma : rounds.noise.sigma;
  rounds.noise.spacing = rounds.noise.spacing < 0 ? noise.spacing : rounds.noise.spacing;
  if (std::exchange (options.noise_varies, false))
    rounds.noise.field = noise.field;
  if (!std::isfinite (rounds.max_displacement) && rounds.noise.sigma > 0)
    rounds.max_displacement = displacement_sigmas * rounds.noise.sigma * rounds.noise.field.largestFactor ();
}

void
prepareSmoothing (const Positions& positions,
                  const Vectors& normals,
                  const Execution& execution,
                  NeighborGraph::ConstPtr& graph,
                  SmoothingOptions& options)
{
  if (!options.robust)
    return;
  using Preparation = SmoothingPreparation;
  const bool estimates = Preparation::needsNoise (options);
  const bool estimates_sheets = options.rounds.sheet_distance < 0 && !options.rounds.oriented;
  NoiseEstimate noise;
  if (estimates)
    noise = estimateNoise (*graph, positions, execution);
  const SheetEstimate sheets =
      estimateSheets (*graph, positions, Preparation::sheetTestDistance (noise, options), execution);
  const bool moves = Preparation::setSheetDistance (noise, sheets, options);
  const SheetSeparationOptions separation = Preparation::separation (options, normals);
  if (moves && separationDepth (separation) >= 0) {
    const NeighborGraph::ConstPtr mixed = graph;
    graph = separateSheets (mixed, positions, separation, execution);
    // Else it would be the same again.
    if (estimates && (graph != mixed || sheets.gap > 0 || mixed->minRowLength () < noise_row_length)) {
      const NoiseSample separated = sampleNoise (*graph, positions, noiseSampleNodes (positions, positions.size ()),
                                                 positions.size (), execution);
      const NoiseEstimate of_sheets = estimateNoise (separated);
      if (estimates_sheets && Preparation::areLayers (noise, of_sheets, sheets)) {
        graph = mixed;
        options.rounds.sheet_distance = std::numeric_limits<float>::infinity ();
      }
      else
        noise = Preparation::chooseNoise (noise, of_sheets, sheets);
    }
  }
  Preparation::setNoise (noise, options);
}

int
smoothingDepth (const SmoothingOptions& options)
{
  const int first_normals = options.normals == NormalSource::INPUT ? 0 : 1;
  if (options.robust)
    return roundsDepth (options.rounds, first_normals);
  return first_normals + options.filter.iterations + options.update.iterations;
}

std::size_t
estimateFirstNormals (const NeighborGraph& graph,
                      const SmoothingOptions& options,
                      const Execution& execution,
                      const Positions& positions,
                      Vectors& normals)
{
  if (options.robust && options.normals == NormalSource::WPCA)
    normals = startNormals (graph, positions, execution.part (0, 0.1));
  else if (options.normals != NormalSource::INPUT)
    normals =
        estimateNormals (graph, positions, makeEstimator (options.normals, options.hough), execution.part (0, 0.3));
  return static_cast<std::size_t> (
      std::count_if (normals.begin (), normals.end (), [] (const auto& n) { return !std::isnan (n.x ()); }));
}

void
requireNormals (std::size_t nodes_with_normal)
{
  if (nodes_with_normal == 0)
    throw Error ("no point has a normal: every neighbourhood has fewer than 3 points or lies on a line; "
                 "the cloud must sample a surface, with a neighbourhood that holds at least 3 points");
}

void
smoothByNormals (const NeighborGraph::ConstPtr& graph,
                 const SmoothingOptions& options,
                 const Research& research,
                 const Execution& execution,
                 Positions& positions,
                 Vectors& normals)
{
  if (options.robust)
    return smoothRobustly (*graph, options.rounds, execution.part (0.3, 1), positions, normals);
  filterNormals (*graph, positions, options.filter, execution.part (0.3, 0.7), normals);
  updatePoints (graph, normals, options.update, research, execution.part (0.7, 1), positions);
}

void
smooth (const NeighborGraph::ConstPtr& graph,
        const SmoothingOptions& options,
        const Research& research,
        const Execution& execution,
        Positions& positions,
        Vectors& normals)
{
  requireNormals (estimateFirstNormals (*graph, options, execution, positions, normals));
  smoothByNormals (graph, options, research, execution, positions, normals);
}
} // namespace core
} // namespace pcl_normal_smoothing
