// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../limits.h"
#include <pcl_normal_smoothing/core/rounds/robust_smoothing.h>

#include <cstddef>

namespace pcl_normal_smoothing
{
namespace core
{
/** Fine rounds use the first 16 entries of a node's row (itself included), other rounds max_row_length. Far rounds
  * use neighbours from outside the row: see FarRows. */
constexpr std::size_t fine_k = 16;

/** Parameters of each round. Covariances are K of doc/robust_smoothing.md: those of a step with the noise of the
  * reference, computed on a plane of pure noise, in variances of the noise. */
struct RoundSchedule
{
  int fine_rounds;     // with smaller neighbourhoods: FineRows
  int first_far_round; // from this round on neighbourhoods are twice as wide: FarRows
  float covariances[max_rounds];
  float wide_covariances[max_rounds]; // for nodes that use max_row_length in the fine rounds too
  float tolerance;                    // factor on the covariances that the risk may reach
  int solves[max_rounds];
  int averages;
  float fine_bandwidth; // of the update, in units of the farthest neighbour's distance; 1 in other rounds
  float sigma_s;        // of the update
};

RoundSchedule
scheduleOf (const RobustSmoothingOptions& options);

/** sigma over the spacing; 0 if the spacing is unknown. */
float
noiseRatio (const RobustSmoothingOptions& options);

/** The ridge on the second-order terms of the quadric fit, as a fraction of the sum of the weights. It grows with
  * the square of noiseRatio, within bounds, as does the part of the fitted curvature that is noise. */
float
ridgeOf (const RobustSmoothingOptions& options);

/** sigma_s of the filter for the fitted normals: about their scatter by the noise; more would turn curved surfaces
  * into facets. 0: no filter. */
float
filteringSigma (const RobustSmoothingOptions& options, int round);

/** Depth of smoothRobustly in hops along the rows: the result of a node depends only on nodes up to that many hops
  * away, and on the rows of those fewer hops away.
  * \param[in] of_normals depth of the initial normals */
int
roundsDepth (const RobustSmoothingOptions& options, int of_normals);
} // namespace core
} // namespace pcl_normal_smoothing
