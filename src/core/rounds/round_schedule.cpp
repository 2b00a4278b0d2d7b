// SPDX-License-Identifier: BSD-3-Clause
#include "round_schedule.h"

#include <algorithm>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
constexpr RoundSchedule fast_schedule = {
    0,                                             // fine_rounds
    2,                                             // first_far_round
    {.690f, .060f, .041f, .0056f, .0038f, .0029f}, // covariances
    {},                                            // wide_covariances
    1.8f,                                          // tolerance
    {2, 1, 1, 1, 1, 1},                            // solves
    3,                                             // averages
    1,                                             // fine_bandwidth
    .06f,                                          // sigma_s
};

constexpr RoundSchedule default_schedule = {
    2,                                               // fine_rounds
    5,                                               // first_far_round
    {.661f, .0745f, .0517f, .0139f, .0080f, .0135f}, // covariances
    {.660f, .084f, .0202f, .0086f, .0052f, .007f},   // wide_covariances
    1.3f,                                            // tolerance
    {3, 2, 2, 2, 1, 1},                              // solves
    4,                                               // averages
    .7f,                                             // fine_bandwidth
    .05f,                                            // sigma_s
};

// sigma_s of the filter as a multiple of noiseRatio, about the scatter of the fitted normals; and its bounds.
constexpr float filtering_of_ratio = .26f, least_filtering = .02f, most_filtering = .15f;
// For the preset fast: the noiseRatio up to which there is no filter, and sigma_s above it.
constexpr float fast_unfiltered_ratio = .29f, fast_filtering = .15f;

// The ridge is ridge_scale times ridge_of_sq_ratio * noiseRatio^2, the latter clamped to the bounds.
constexpr float ridge_scale = .3f, ridge_of_sq_ratio = .15f, least_ridge = .003f, most_ridge = .01f;
} // namespace

float
noiseRatio (const RobustSmoothingOptions& options)
{
  return options.noise.spacing > 0 ? options.noise.sigma / options.noise.spacing : 0;
}

RoundSchedule
scheduleOf (const RobustSmoothingOptions& options)
{
  return options.fast ? fast_schedule : default_schedule;
}

float
ridgeOf (const RobustSmoothingOptions& options)
{
  const float noise_ratio = noiseRatio (options);
  return ridge_scale * std::clamp (ridge_of_sq_ratio * noise_ratio * noise_ratio, least_ridge, most_ridge);
}

float
filteringSigma (const RobustSmoothingOptions& options, int round)
{
  const float noise_ratio = noiseRatio (options);
  if (options.fast)
    return noise_ratio > fast_unfiltered_ratio ? fast_filtering : 0;
  return round > 0 ? std::clamp (filtering_of_ratio * noise_ratio, least_filtering, most_filtering) : 0;
}

int
roundsDepth (const RobustSmoothingOptions& options, int of_normals)
{
  if (options.count == 0)
    return of_normals;
  const RoundSchedule schedule = scheduleOf (options);
  // The first fit reads the node's own normal and the neighbours' positions; later ones, and the first if oriented, the
  // neighbours' normals too. FineRows chooses its row by reading the neighbours' rows.
  const int of_neighbors = options.oriented ? of_normals : 0, of_row = schedule.fine_rounds > 0 ? 2 : 1;
  const int first_fit = std::max ({of_normals, of_row, 1 + of_neighbors});
  constexpr int fit = 1, update = 1;
  int all = first_fit - fit;
  for (int round = 0; round < options.count; ++round) {
    const int hops = round < schedule.first_far_round ? 1 : 2; // far rows reach neighbours of neighbours
    all += hops * (fit + (filteringSigma (options, round) > 0 ? 1 : 0) + update) + schedule.averages;
  }
  constexpr int keep_apart = 1;
  return all + keep_apart;
}
} // namespace core
} // namespace pcl_normal_smoothing
