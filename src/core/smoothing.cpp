// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/error.h>
#include <pcl_normal_smoothing/core/sheet_separation.h>
#include <pcl_normal_smoothing/core/smoothing.h>

#include <algorithm>
#include <cmath>

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

void
requireNormals (const Vectors& normals)
{
  if (std::all_of (normals.begin (), normals.end (), [] (const auto& n) { return std::isnan (n.x ()); }))
    throw Error ("no point has a normal: every neighbourhood has fewer than 3 points or lies on a line; "
                 "the cloud must sample a surface, with a neighbourhood that holds at least 3 points");
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
  convert (options.rounds.sheet_distance);
  return options;
}

void
check (const SmoothingOptions& options)
{
  check (options.filter);
  check (options.update);
  RobustSmoothingOptions rounds = options.rounds;
  rounds.noise.sigma = std::max (rounds.noise.sigma, 0.0f); // below 0 means that it is to be estimated
  rounds.noise.spacing = std::max (rounds.noise.spacing, 0.0f);
  rounds.sheet_distance = std::max (rounds.sheet_distance, 0.0f);
  if (options.robust)
    check (rounds);
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
  RobustSmoothingOptions& rounds = options.rounds;
  NoiseEstimate& noise = rounds.noise;
  const bool noise_known = noise.sigma >= 0 && noise.spacing >= 0;
  NoiseEstimate estimate;
  if (!noise_known)
    estimate = estimateNoise (*graph, positions, execution);
  const float sigma = noise.sigma >= 0 ? noise.sigma : estimate.sigma;
  if (rounds.sheet_distance < 0)
    rounds.sheet_distance = sheet_sigmas * sigma;

  if (sigma > 0) { // else nothing moves
    const bool oriented = rounds.oriented && options.normals == NormalSource::INPUT;
    const NeighborGraph::ConstPtr mixed = graph;
    graph = separateSheets (mixed, positions, {rounds.sheet_distance, oriented ? &normals : nullptr}, execution);
    if (graph != mixed && !noise_known)
      estimate.sigma = std::min (estimateNoise (*graph, positions, execution).sigma, 1.2f * estimate.sigma);
  }
  noise.sigma = noise.sigma < 0 ? estimate.sigma : noise.sigma;
  noise.spacing = noise.spacing < 0 ? estimate.spacing : noise.spacing;
  if (!std::isfinite (rounds.max_displacement) && noise.sigma > 0)
    rounds.max_displacement = displacement_sigmas * noise.sigma;
}

void
smooth (const NeighborGraph::ConstPtr& graph,
        const SmoothingOptions& options,
        const Research& research,
        const Execution& execution,
        Positions& positions,
        Vectors& normals)
{
  if (options.robust && options.normals == NormalSource::WPCA)
    normals = startNormals (*graph, positions, execution.part (0, 0.1));
  else if (options.normals != NormalSource::INPUT)
    normals =
        estimateNormals (*graph, positions, makeEstimator (options.normals, options.hough), execution.part (0, 0.3));
  requireNormals (normals);
  if (options.robust)
    return smoothRobustly (*graph, options.rounds, execution.part (0.3, 1), positions, normals);
  filterNormals (*graph, positions, options.filter, execution.part (0.3, 0.7), normals);
  updatePoints (graph, normals, options.update, research, execution.part (0.7, 1), positions);
}
} // namespace core
} // namespace pcl_normal_smoothing
