// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "local_points.h"
#include "normal_filter.h"

namespace pcl_normal_smoothing
{
namespace core
{
namespace PCL_NORMAL_SMOOTHING_ISA
{
// Of a block in AveragingWeights, which packs two neighbours of a node into one byte.
constexpr std::size_t bytes_per_neighbor = block_size / 2;

/** The limit on the risk of the lanes' steps. */
LANES_INLINE Lanes
limitOf (const RiskLimit& limit, const std::uint32_t* own)
{
  return limit.usual * load1OrOne (limit.factors, own);
}

/** The risk of a proposed step d along the point's normal n: (distance moved since the first round) * d.n, and
  * |d.n|. The first is bounded: an outlier, which moves the same way round after round, says nothing about the
  * points around. */
LANES_INLINE void
stepRisks (const StepRisks& task, const BlockRows& rows, int first)
{
  const std::uint32_t* own = rows.neighbors + first;
  const Lanes3 normal = load3 (task.nodes.normals, own), offset = load3OrZero (task.nodes.offset, own);
  const Lanes step = dot (load3 (task.proposed, own) - offset, normal);
  const Mask valid = normal.x == normal.x;
  const Lanes bound = 3 * limitOf (task.limit, own);
  const Lanes product = minimum (maximum (load1 (task.moved, own) * step, -bound), bound);
  store2 (task.risks, own, {valid ? product : splat (0), valid ? absolute (step) : splat (0)});
}

/** Weights for averaging over neighbours, from 0 to 15: by distance and similarity of the normals. */
LANES_INLINE void
averagingWeights (const AveragingWeights& task, const BlockRows& rows, int first)
{
  const std::uint32_t* own = rows.neighbors + first;
  std::uint8_t* weights = task.weights + rows.pairs_begin + first;
  const Lanes3 own_normal = load3 (task.nodes.normals, own);
  const LocalPoints local (task.nodes, rows, own);
  const auto weightOf = [&] (std::size_t j) LANES_LAMBDA {
    const Lanes cosine = dot (own_normal, load3 (task.nodes.normals, own + block_size * j));
    const Lanes x = 1 - similarity (cosine, task.oriented);
    const Lanes exponent = 0.5f * dot (local.at[j], local.at[j]) + x * 2.0408163f; // |n_i - n_j|^2 / (2 .7^2)
    const Lanes weight = x == x ? local.one[j] * bell (exponent) : splat (0);
    return __builtin_convertvector(weight * 15.0f + 0.5f, Mask);
  };
  for (std::size_t j = 0; j < local.count; j += 2) {
    const Mask second = j + 1 < local.count ? weightOf (j + 1) : Mask {};
    const Bytes pair = __builtin_convertvector(weightOf (j) | (second << 4), Bytes);
    std::memcpy (weights + bytes_per_neighbor * j, &pair, sizeof pair);
  }
}

/** Averages the risks over the neighbourhoods, once. */
LANES_INLINE void
averageRisks (const RiskAverages& task, const BlockRows& rows, int first)
{
  const std::uint32_t* own = rows.neighbors + first;
  const std::uint8_t* weights = task.weights + rows.pairs_begin + first;
  const std::size_t count = rows.length < max_row_length ? rows.length : max_row_length;
  Lanes sum_product = {}, sum_size = {}, sum = {};
  const auto add = [&] (Mask number, std::size_t j) LANES_LAMBDA {
    const Lanes weight = __builtin_convertvector(number, Lanes);
    const Lanes2 risk = load2 (task.risks, own + block_size * j);
    sum += weight;
    sum_product += weight * risk.x;
    sum_size += weight * risk.y;
  };
  for (std::size_t j = 0; j < count; j += 2) {
    const Mask pair = __builtin_convertvector(load<Bytes> (weights + bytes_per_neighbor * j), Mask);
    add (pair & 15, j);
    if (j + 1 < count)
      add (pair >> 4, j + 1);
  }
  const Lanes scale = sum > 0 ? 1 / sum : splat (0);
  store2 (task.averaged, own, {scale * sum_product, scale * sum_size});
}

/** Takes the share of the proposed step that the risk allows. With a and s the averages of stepRisks, the mean
  * square of the step is q = (pi / 2) s^2 (from its mean size, as for a Gaussian: heavy tails count less). The share
  * is the fourth power of (limit - a) / q, clamped to [0, 1]: nearly all of the step or little. */
LANES_INLINE void
takeSteps (const StepsToTake& task, const BlockRows& rows, int first)
{
  const std::uint32_t* own = rows.neighbors + first;
  const Lanes3 offset = load3OrZero (task.nodes.offset, own), start = load3OrZero (task.start, own);
  const Lanes2 risk = load2 (task.risks, own);
  const Lanes q = 1.57079633f * (risk.y * risk.y);
  Lanes share = q > 0 ? minimum (maximum ((limitOf (task.limit, own) - risk.x) / q, splat (0)), splat (1)) : splat (0);
  share *= share;
  share *= share;
  // The taken steps may be stored in place of the proposed ones.
  const Lanes3 step = load3Alone (task.proposed, own) - offset;
  const Lanes3 taken = start + capped ((offset + share * step) - start, task.max_displacement);
  store3 (task.taken, own, taken);
  if (task.moved != nullptr) {
    const Lanes moved = dot (taken - offset, load3 (task.nodes.normals, own));
    store1 (task.moved, own, load1 (task.moved, own) + (moved == moved ? moved : splat (0)));
  }
}
} // namespace PCL_NORMAL_SMOOTHING_ISA
} // namespace core
} // namespace pcl_normal_smoothing
