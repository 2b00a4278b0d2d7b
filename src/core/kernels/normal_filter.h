// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lanes.h"

#include <pcl_normal_smoothing/core/kernels.h>

namespace pcl_normal_smoothing
{
namespace core
{
namespace PCL_NORMAL_SMOOTHING_ISA
{
/** 1 / (2 sigma_c^2) of eq. 5, sigma_c the mean distance to the other points of the row; 0 where that is 0. */
LANES_INLINE void
distanceFactors (const NumberOfNodes& factors, const BlockRows& rows, int first)
{
  const std::uint32_t* own = rows.neighbors + first;
  const Points points (factors.nodes.base, factors.nodes.offset, own);
  Lanes sum = {}, count = {};
  for (std::size_t j = 1; j < rows.length; ++j) {
    const std::uint32_t* neighbor = own + 16 * j;
    const Lanes3 difference = points.difference (neighbor);
    const Lanes one = isOther (neighbor, own) ? splat (1) : splat (0);
    sum += one * squareRoot (dot (difference, difference));
    count += one;
  }
  const Lanes sigma_c = sum / count;
  store1 (factors.numbers, own, sum > 0 ? 1 / (2 * (sigma_c * sigma_c)) : splat (0));
}

/** n_i.s n_j; turns n_j to s n_j, the side of n_i. */
LANES_INLINE Lanes
turn (Lanes3& normal, Lanes3 own, bool oriented)
{
  const Lanes cosine = dot (own, normal);
  if (oriented)
    return cosine;
  const Lanes sign = cosine > 0 ? splat (1) : splat (-1); // NaN stays NaN in both
  normal = sign * normal;
  return sign * cosine;
}

/** T of eq. 7 for the neighbourhoods of the lanes. */
LANES_INLINE Lanes
mixedThreshold (const NormalFilterStep& step, const BlockRows& rows, const std::uint32_t* own, Lanes3 own_normal)
{
  Lanes sum = {}, count = splat (1);
  for (std::size_t j = 1; j < rows.length; ++j) {
    const std::uint32_t* neighbor = own + 16 * j;
    Lanes3 normal = load3 (step.nodes.normals, neighbor);
    const Lanes x = 1 - turn (normal, own_normal, step.oriented);
    const Mask other = isOther (neighbor, own);
    sum += (other & (x == x)) ? x * x : splat (0);
    count += other ? splat (1) : splat (0);
  }
  return step.rms ? squareRoot (sum / count) : squareRoot (sum) / count;
}

/** One iteration of eq. 2 with the weight of eq. 3 (0), eqs. 4 and 5 (1), or eqs. 6 and 7 (2). */
template <int weight_kind>
LANES_INLINE void
filterNormals (const NormalFilterStep& step, const BlockRows& rows, int first)
{
  const std::uint32_t* own = rows.neighbors + first;
  const Points points (step.nodes.base, step.nodes.offset, own);
  const Lanes3 own_normal = load3 (step.nodes.normals, own);
  const Lanes distance_factor = load1 (step.distance_factor, own);
  const Lanes mixed_threshold = weight_kind == 2 ? mixedThreshold (step, rows, own, own_normal) : Lanes {};
  Lanes3 sum = {};
  for (std::size_t j = 0; j < rows.length; ++j) {
    const std::uint32_t* neighbor = own + 16 * j;
    Lanes3 normal = load3 (step.nodes.normals, neighbor);
    const Lanes cosine = turn (normal, own_normal, step.oriented);
    Lanes weight;
    if (weight_kind == 0) {
      const Lanes above = cosine - step.threshold;
      weight = above > 0 ? above * above : splat (0); // eq. 3
    }
    else {
      const Lanes3 difference = points.difference (neighbor);
      const Lanes distance_term = dot (difference, difference) * distance_factor;
      const Lanes x = 1 - cosine; // (n_i - s n_j).n_i of unit normals; |n_i - s n_j|^2 is twice this
      const Lanes below = mixed_threshold - x;
      if (weight_kind == 1) // eqs. 4 and 5, the two Gaussians in one exponential
        weight = expOfMinus (distance_term + maximum (2 * x, splat (0)) * step.normal_factor);
      else // eqs. 6 and 7
        weight = below > 0 ? expOfMinus (distance_term) * (below * below) : splat (0);
    }
    const Mask counts = (cosine == cosine) & (isOther (neighbor, own) | (j == 0 ? -1 : 0));
    const Lanes3 term = weight * normal;
    sum.x += counts ? term.x : splat (0); // eq. 2
    sum.y += counts ? term.y : splat (0);
    sum.z += counts ? term.z : splat (0);
  }
  const Lanes length = squareRoot (dot (sum, sum));
  const Mask any = length > 0;
  store3 (step.filtered, own,
          {any ? sum.x / length : own_normal.x, any ? sum.y / length : own_normal.y,
           any ? sum.z / length : own_normal.z});
}
} // namespace PCL_NORMAL_SMOOTHING_ISA
} // namespace core
} // namespace pcl_normal_smoothing
