// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "neighbor_values.h"

#include "../kernels.h"

namespace pcl_normal_smoothing
{
namespace core
{
namespace PCL_NORMAL_SMOOTHING_ISA
{
/** exp (-d^2 / (2 sigma_c^2)) of eq. 4, sigma_c the mean distance to the other points of the row; 1 where that is 0. */
LANES_INLINE void
distanceWeights (const DistanceWeights& task, const BlockRows& rows, int first)
{
  const std::uint32_t* own = rows.neighbors + first;
  const Points points (task.nodes.base, task.nodes.offset, own);
  const auto read = [&] (std::size_t j) LANES_LAMBDA { return points.difference (own + block_size * j); };
  const NeighborValues<Lanes3, decltype (read)> differences (read, rows.length);
  Lanes sum = {}, count = {};
  for (std::size_t j = 1; j < rows.length; ++j) {
    const Lanes one = isOther (own + block_size * j, own) ? splat (1) : splat (0);
    sum += one * squareRoot (dot (differences (j), differences (j)));
    count += one;
  }
  const Lanes sigma_c = sum / count;
  const Lanes factor = sum > 0 ? 1 / (2 * (sigma_c * sigma_c)) : splat (0);
  for (std::size_t j = 0; j < rows.length; ++j) {
    Lanes weight = expOfMinus (dot (differences (j), differences (j)) * factor);
    weight = isOther (own + block_size * j, j == 0 ? no_nodes : own) ? weight : splat (0);
    storeShorts (task.weights + rows.begin + first + block_size * j,
                 max_short * maximum (weight, splat (0))); // NaN: too far away
  }
}

/** The cosine n_i.s n_j of unit normals, where s flips n_j to the side of n_i unless normals are oriented. NaN where
  * either normal is. */
LANES_INLINE Lanes
similarity (Lanes cosine, bool oriented)
{
  return oriented ? cosine : absolute (cosine);
}

/** \a number times s, the sign in similarity. */
LANES_INLINE Lanes
turned (Lanes number, Lanes cosine, bool oriented)
{
  return oriented ? number : withSignOf (number, cosine);
}

/** The threshold T of eq. 7 for the lanes' neighbourhoods. */
template <typename Normals>
LANES_INLINE Lanes
mixedThreshold (const NormalFilterStep& step, const BlockRows& rows, const std::uint32_t* own, const Normals& normals)
{
  Lanes sum = {}, count = splat (1);
  for (std::size_t j = 1; j < rows.length; ++j) {
    const Lanes x = 1 - similarity (dot (normals (0), normals (j)), step.oriented);
    const Mask other = isOther (own + block_size * j, own);
    sum += (other & (x == x)) ? x * x : splat (0);
    count += other ? splat (1) : splat (0);
  }
  return step.mixed_threshold == MixedThreshold::RMS ? squareRoot (sum / count) : squareRoot (sum) / count;
}

/** The weight of eq. 3, or the factor for the normal in that of eq. 4 or eq. 6. */
template <NormalWeight kind>
LANES_INLINE Lanes
normalWeight (const NormalFilterStep& step, Lanes threshold, Lanes likeness)
{
  if (kind == NormalWeight::GAUSSIAN) // |n_i - s n_j|^2 of unit normals is twice 1 - n_i.s n_j
    return expOfMinus (maximum (1 - likeness, splat (0)) * (2 * step.normal_factor));
  const Lanes inside =
      maximum (kind == NormalWeight::THRESHOLD ? likeness - threshold : threshold - (1 - likeness), splat (0));
  return inside * inside;
}

/** The sum of eq. 2.
  * \tparam complete all nodes have normals, and the rows of the lanes' nodes are as long as the block's
  * \param[in] threshold T of eq. 3 or eq. 7
  * \param[in] normals gives the normals of the lanes' j-th neighbours */
template <NormalWeight kind, bool complete, typename Normals>
LANES_INLINE Lanes3
weightedSum (const NormalFilterStep& step, const BlockRows& rows, int first, Lanes threshold, const Normals& normals)
{
  const std::uint32_t* own = rows.neighbors + first;
  const Lanes3 own_normal = load3 (step.nodes.normals, own);
  Lanes3 sum = {};
  for (std::size_t j = 0; j < rows.length; ++j) {
    const Lanes3 normal = normals (j);
    const Lanes cosine = dot (own_normal, normal);
    Lanes weight = normalWeight<kind> (step, threshold, similarity (cosine, step.oriented));
    if (kind != NormalWeight::THRESHOLD)
      weight *= loadShorts (step.distance_weights + rows.begin + first + block_size * j);
    const Mask counts = (cosine == cosine) & isOther (own + block_size * j, j == 0 ? no_nodes : own);
    const Lanes3 term = turned (weight, cosine, step.oriented) * normal;
    sum = sum + (complete ? term : choose (counts, term, Lanes3 {}));
  }
  return sum;
}

/** One iteration of eq. 2. */
template <NormalWeight kind, bool complete>
LANES_INLINE void
filterNormals (const NormalFilterStep& step, const BlockRows& rows, int first)
{
  const std::uint32_t* own = rows.neighbors + first;
  const auto read = [&] (std::size_t j) LANES_LAMBDA { return load3 (step.nodes.normals, own + block_size * j); };
  Lanes3 sum;
  if constexpr (kind == NormalWeight::MIXED) {
    const NeighborValues<Lanes3, decltype (read)> normals (read, rows.length);
    sum = weightedSum<kind, complete> (step, rows, first, mixedThreshold (step, rows, own, normals), normals);
  }
  else {
    sum = weightedSum<kind, complete> (step, rows, first, splat (step.threshold), read);
  }
  const Lanes length = squareRoot (dot (sum, sum));
  store3 (step.filtered, own, choose (length > 0, sum / length, load3 (step.nodes.normals, own)));
}
} // namespace PCL_NORMAL_SMOOTHING_ISA
} // namespace core
} // namespace pcl_normal_smoothing
