// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../limits.h"
#include <pcl_normal_smoothing/core/rounds/robust_smoothing.h>

#include <cstddef>

namespace pcl_normal_smoothing
{
namespace core
{
/** How many nodes fine rounds look at, others at max_row_length: the first of the node's row, itself counted. Far
  * rounds look at others, which are not in it: see FarRows. */
constexpr std::size_t fine_k = 16;

/** How much is done in which round. A gain is what a step may cost: the covariance of the point after the first round
  * with the step, on a plane of pure noise, in variances of the noise. */
struct RoundSchedule
{
  int fine_rounds;     // with the smaller neighbourhood: FineRows
  int first_far_round; // from there on with one twice as wide: FarRows
  float gains[max_rounds];
  float wide_gains[max_rounds]; // of nodes that look at max_row_length in the fine rounds too
  float tolerance;              // of the risk: a factor of the gains
  int solves[max_rounds];
  int averages;
  float fine_bandwidth; // of the update, in distances of the farthest neighbour; 1 in other rounds
  float sigma_s;        // of the update
};

RoundSchedule
scheduleOf (const RobustSmoothingOptions& options);

/** sigma over the spacing; 0 where none is known. */
float
noiseRatio (const RobustSmoothingOptions& options);

/** The ridge of the quadric fit, on its second-order terms, in shares of the sum of the weights: it grows with the
  * square of noiseRatio, within bounds, as does what is noise of the curvature that is fitted. */
float
ridgeOf (const RobustSmoothingOptions& options);

/** sigma_s of the pass over the fitted normals: what they scatter by the noise and not more, or curved surfaces become
  * facets. 0: there is no pass. */
float
filteringSigma (const RobustSmoothingOptions& options, int round);

/** How far along the rows smoothRobustly looks: what becomes of a node depends on nodes that are so many hops off, and
  * on the rows of those that are fewer hops off, on nothing else.
  * \param[in] of_normals how far the normals look that it starts from */
int
roundsDepth (const RobustSmoothingOptions& options, int of_normals);
} // namespace core
} // namespace pcl_normal_smoothing
