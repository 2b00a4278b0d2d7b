// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "local_points.h"

namespace pcl_normal_smoothing
{
namespace core
{
namespace PCL_NORMAL_SMOOTHING_ISA
{
constexpr std::size_t max_candidates = 16;

/** How far a neighbourhood supports a candidate. Each neighbour is weighted by its distance, exp (-d^2 / (2 .5^2))
  * in units of the reach; kept as exponents. */
struct Electorate
{
  const LocalPoints& local;
  Lanes exponents[max_row_length];
  Lanes3 normals[max_row_length]; // only if they count
  Lanes height_factor;

  LANES_INLINE
  Electorate (const NormalVoteStep& step, const LocalPoints& of_local, const std::uint32_t* own)
  : local (of_local), height_factor (step.height_factor * (of_local.reach * of_local.reach))
  {
    for (std::size_t j = 0; j < local.count; ++j) {
      exponents[j] = 2 * dot (local.at[j], local.at[j]);
      if (step.agreement > 0)
        normals[j] = load3 (step.nodes.normals, own + block_size * j);
    }
  }

  /** Support by position: the nearer a point lies to the candidate's plane, the more it counts. */
  LANES_INLINE Lanes
  ofPoints (Lanes3 candidate) const
  {
    Lanes support = {};
    for (std::size_t j = 0; j < local.count; ++j) {
      const Lanes height = dot (candidate, local.at[j]);
      support += local.one[j] * bell (exponents[j] + height * height * height_factor);
    }
    return support;
  }

  /** Support by the normals: exp (-|n - n_j|^2 / (2 .41^2)), regardless of the sign. */
  LANES_INLINE Lanes
  ofNormals (Lanes3 candidate) const
  {
    Lanes support = {};
    for (std::size_t j = 0; j < local.count; ++j) {
      const Lanes x = 1 - absolute (dot (candidate, normals[j]));
      support += x == x ? local.one[j] * bell (exponents[j] + 6 * x) : splat (0);
    }
    return support;
  }
};

/** Elects, among the normals of the nearest points (the point's own first), the one that the neighbourhood supports
  * most. */
LANES_INLINE void
electNormals (const NormalVoteStep& step, const BlockRows& rows, int first)
{
  const std::uint32_t* own = rows.neighbors + first;
  const LocalPoints local (step.nodes, rows, own);
  const Electorate electorate (step, local, own);
  Lanes3 elected = load3 (step.nodes.normals, own);
  Lanes most = splat (-1);
  const std::size_t candidates = local.count < max_candidates ? local.count : max_candidates;
  for (std::size_t c = 0; c < candidates; ++c) {
    const Lanes3 normal = load3 (step.nodes.normals, own + block_size * c);
    Lanes support = electorate.ofPoints (normal);
    if (step.agreement > 0)
      support += step.agreement * electorate.ofNormals (normal);
    const Mask better = (normal.x == normal.x) & (support > most);
    elected = choose (better, normal, elected);
    most = better ? support : most;
  }
  store3 (step.elected, own, elected);
}
} // namespace PCL_NORMAL_SMOOTHING_ISA
} // namespace core
} // namespace pcl_normal_smoothing
