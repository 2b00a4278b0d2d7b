// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lane_vectors.h"

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

/** n_i.s n_j of unit normals, s the sign that turns n_j to the side of n_i where normals are not oriented. NaN where one is. */
LANES_INLINE Lanes
similarity (Lanes cosine, bool oriented)
{
  return oriented ? cosine : absolute (cosine);
}

/** \a number times that s. */
LANES_INLINE Lanes
turned (Lanes number, Lanes cosine, bool oriented)
{
  if (oriented)
    return number;
  return cosine > 0 ? number : -number;
}

/** T of eq. 7 for the neighbourhoods of the lanes. */
LANES_INLINE Lanes
mixedThreshold (const NormalFilterStep& step, const BlockRows& rows, const std::uint32_t* own, Lanes3 own_normal)
{
  Lanes sum = {}, count = splat (1);
  for (std::size_t j = 1; j < rows.length; ++j) {
    const std::uint32_t* neighbor = own + 16 * j;
    const Lanes cosine = dot (own_normal, load3 (step.nodes.normals, neighbor));
    const Lanes x = 1 - similarity (cosine, step.oriented);
    const Mask other = isOther (neighbor, own);
    sum += (other & (x == x)) ? x * x : splat (0);
    count += other ? splat (1) : splat (0);
  }
  return step.rms ? squareRoot (sum / count) : squareRoot (sum) / count;
}

/** What the weights of a row share. */
struct FilterFactors
{
  Lanes distance;        // 1 / (2 sigma_c^2)
  Lanes normal;          // 1 / sigma_s^2: |n_i - s n_j|^2 of unit normals is twice 1 - n_i.s n_j
  Lanes mixed_threshold; // T
};

/** The weight of eq. 3 (kind 0), eqs. 4 and 5 (1), or eqs. 6 and 7 (2). */
template <int kind>
LANES_INLINE Lanes
filterWeight (const FilterFactors& factors, float threshold, Lanes3 difference, Lanes likeness)
{
  if (kind == 0) {
    const Lanes above = maximum (likeness - threshold, splat (0));
    return above * above;
  }
  const Lanes distance_term = dot (difference, difference) * factors.distance, x = 1 - likeness;
  if (kind == 1) // the two Gaussians in one exponential
    return expOfMinus (distance_term + maximum (x, splat (0)) * factors.normal);
  const Lanes below = maximum (factors.mixed_threshold - x, splat (0));
  return expOfMinus (distance_term) * (below * below);
}

/** One iteration of eq. 2. */
template <int kind>
LANES_INLINE void
filterNormals (const NormalFilterStep& step, const BlockRows& rows, int first)
{
  const std::uint32_t* own = rows.neighbors + first;
  const Points points (step.nodes.base, step.nodes.offset, own);
  const Lanes3 own_normal = load3 (step.nodes.normals, own);
  const FilterFactors factors {load1 (step.distance_factor, own), splat (2 * step.normal_factor),
                               kind == 2 ? mixedThreshold (step, rows, own, own_normal) : Lanes {}};
  Lanes3 sum = {};
  for (std::size_t j = 0; j < rows.length; ++j) {
    const std::uint32_t* neighbor = own + 16 * j;
    Lanes3 normal, difference;
    if (kind == 0) // needs no positions
      normal = load3 (step.nodes.normals, neighbor);
    else
      difference = points.difference (neighbor, step.nodes.normals, normal);
    const Lanes cosine = dot (own_normal, normal);
    const Lanes weight = filterWeight<kind> (factors, step.threshold, difference, similarity (cosine, step.oriented));
    const Lanes3 term = turned (weight, cosine, step.oriented) * normal;
    const Mask counts = (cosine == cosine) & isOther (neighbor, j == 0 ? no_nodes : own);
    sum.x += counts ? term.x : splat (0);
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
