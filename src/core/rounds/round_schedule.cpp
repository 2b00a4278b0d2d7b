// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/rounds/round_schedule.h>

#include <algorithm>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
// Noise against spacing from which on only large neighbourhoods serve.
constexpr float coarse_ratio = .62f;
} // namespace

float
noiseRatio (const RobustSmoothingOptions& options)
{
  return options.noise.spacing > 0 ? options.noise.sigma / options.noise.spacing : 0;
}

RoundSchedule
chooseSchedule (const RobustSmoothingOptions& options)
{
  if (options.fast)
    return {0, 2, {.690f, .060f, .041f, .0056f, .0038f, .0029f}, 1.8f, {2, 1, 1, 1, 1, 1}, 3, 1, .06f};
  if (noiseRatio (options) >= coarse_ratio)
    return {0, 5, {.660f, .084f, .0202f, .0086f, .0052f, .007f}, 1.3f, {3, 2, 2, 2, 1, 1}, 4, 1, .05f};
  return {2, 5, {.661f, .0745f, .0517f, .0139f, .0080f, .0135f}, 1.3f, {3, 2, 2, 2, 1, 1}, 4, .7f, .05f};
}

float
filteringSigma (const RobustSmoothingOptions& options, int round)
{
  const float noise_ratio = noiseRatio (options);
  if (options.fast)
    return noise_ratio > .29f ? .15f : 0;
  return round > 0 ? std::clamp (.26f * noise_ratio, .02f, .15f) : 0;
}

int
roundsDepth (const RobustSmoothingOptions& options, int of_normals)
{
  if (options.rounds == 0)
    return of_normals;
  // The first fit reads the node's own normal and the neighbours' positions; later ones, or oriented, their normals too.
  const int first_fit = std::max (of_normals, 1 + (options.oriented ? of_normals : 0));
  const RoundSchedule schedule = chooseSchedule (options);
  constexpr int fit = 1, update = 1;
  int all = first_fit - fit;
  for (int round = 0; round < options.rounds; ++round) {
    const int hops = round < schedule.first_far_round ? 1 : 2; // to neighbours of neighbours
    all += hops * (fit + (filteringSigma (options, round) > 0 ? 1 : 0) + update) + schedule.averages;
  }
  constexpr int keep_apart = 1;
  return all + keep_apart;
}
} // namespace core
} // namespace pcl_normal_smoothing
