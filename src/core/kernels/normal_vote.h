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

/** Of the normals of the nearest points, the point's own first, elects that whose plane through the point has the most
  * neighbours near: each counts exp (-d^2 / (2 .5^2)) in units of the reach, times a bell of its distance from the plane. */
LANES_INLINE void
electNormals (const NormalVoteStep& step, const BlockRows& rows, int first)
{
  const std::uint32_t* own = rows.neighbors + first;
  const LocalPoints local (step.nodes, rows, own);
  const Lanes height_factor = step.height_factor * (local.reach * local.reach);
  Lanes exponents[max_fit_neighbors];
  for (std::size_t j = 0; j < local.count; ++j)
    exponents[j] = 2 * dot (local.at[j], local.at[j]);

  Lanes3 elected = load3 (step.nodes.normals, own);
  Lanes most = splat (-1);
  const std::size_t candidates = local.count < max_candidates ? local.count : max_candidates;
  for (std::size_t c = 0; c < candidates; ++c) {
    const Lanes3 normal = load3 (step.nodes.normals, own + 16 * c);
    Lanes support = {};
    for (std::size_t j = 0; j < local.count; ++j) {
      const Lanes height = dot (normal, local.at[j]);
      support += local.one[j] * bell (exponents[j] + height * height * height_factor);
    }
    const Mask better = (normal.x == normal.x) & (support > most);
    elected = choose (better, normal, elected);
    most = better ? support : most;
  }
  store3 (step.elected, own, elected);
}
} // namespace PCL_NORMAL_SMOOTHING_ISA
} // namespace core
} // namespace pcl_normal_smoothing
