// SPDX-License-Identifier: BSD-3-Clause
#include "rounds/round_schedule.h"

#include "limits.h"
#include <pcl_normal_smoothing/core/error.h>
#include <pcl_normal_smoothing/core/smoothing.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace pcl_normal_smoothing
{
namespace core
{
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
    throw Error ("oriented normals are asked for, but those that are estimated have arbitrary signs: "
                 "give oriented ones with the input (NormalSource::INPUT), or call setNormalsOriented (false)");
  RobustSmoothingOptions rounds = options.rounds;
  rounds.noise.sigma = std::max (rounds.noise.sigma, 0.0f); // below 0 means that it is to be estimated
  rounds.noise.spacing = std::max (rounds.noise.spacing, 0.0f);
  rounds.sheet_distance = std::max (rounds.sheet_distance, 0.0f);
  if (options.in_rounds)
    check (rounds);
}

void
checkNeighborCount (const SmoothingOptions& options, int k)
{
  if (!options.in_rounds)
    return checkNeighborCount (options.normals, k);
  if (k > 0 && k < min_fit_points)
    throw Error ("k is " + std::to_string (k) + ", but the rounds fit quadrics, which need " +
                 std::to_string (min_fit_points) + " points: give k of at least " + std::to_string (min_fit_points));
}

int
smoothingDepth (const SmoothingOptions& options)
{
  const int first_normals = options.normals == NormalSource::INPUT ? 0 : 1;
  if (options.in_rounds)
    return roundsDepth (options.rounds, first_normals);
  return first_normals + options.filter.iterations + options.update.iterations;
}

std::size_t
countNormals (const Vectors& normals)
{
  return static_cast<std::size_t> (
      std::count_if (normals.begin (), normals.end (), [] (const auto& n) { return !std::isnan (n.x ()); }));
}

std::size_t
estimateFirstNormals (const NeighborGraph& graph,
                      const SmoothingOptions& options,
                      const Execution& execution,
                      MovingSurface& surface)
{
  Vectors& normals = surface.normals;
  if (options.in_rounds && options.normals == NormalSource::WPCA)
    normals = startNormals (graph, surface.positions, execution.part (0, 0.1));
  else if (options.normals != NormalSource::INPUT)
    normals = estimateNormals (graph, surface.positions, makeEstimator (options.normals, options.hough),
                               execution.part (0, 0.3));
  return countNormals (normals);
}

void
requireNormals (std::size_t nodes_with_normal, NormalSource source)
{
  if (nodes_with_normal > 0)
    return;
  if (source == NormalSource::INPUT)
    throw Error ("no point has a normal: all that are read are zero or not finite; estimate them, or choose another "
                 "normal source");
  throw Error ("no point has a normal: every neighbourhood has fewer than 3 points, in WPCA 4, or lies on a line; "
               "if there is a radius, give a larger one; the cloud must sample a surface");
}

void
smoothByNormals (const NeighborGraph::ConstPtr& graph,
                 const SmoothingOptions& options,
                 const SearchAgain& search_again,
                 const Execution& execution,
                 MovingSurface& surface)
{
  if (options.in_rounds)
    return smoothRobustly (*graph, options.rounds, execution.part (0.3, 1), surface);
  filterNormals (*graph, surface.positions, options.filter, execution.part (0.3, 0.7), surface.normals);
  updatePoints (graph, surface.normals, options.update, search_again, execution.part (0.7, 1), surface.positions);
}

void
smooth (const NeighborGraph::ConstPtr& graph,
        const SmoothingOptions& options,
        const SearchAgain& search_again,
        const Execution& execution,
        MovingSurface& surface)
{
  requireNormals (estimateFirstNormals (*graph, options, execution, surface), options.normals);
  smoothByNormals (graph, options, search_again, execution, surface);
}
} // namespace core
} // namespace pcl_normal_smoothing
