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
/** What a proposed step d tells of the risk, along the point's normal: (p - reference).n (d.n), and |d.n|. */
LANES_INLINE void
stepRisks (const StepControl& control, const BlockRows& rows, int first)
{
  const std::uint32_t* own = rows.neighbors + first;
  const Lanes3 normal = load3 (control.nodes.normals, own), offset = load3 (control.nodes.offset, own);
  const Lanes step = dot (load3 (control.proposed, own) - offset, normal);
  const Lanes moved = dot (offset - load3 (control.reference, own), normal);
  const Mask valid = normal.x == normal.x;
  store3 (control.risks, own, {valid ? moved * step : splat (0), valid ? absolute (step) : splat (0), Lanes {}});
}

/** Weights for averaging over neighbours: near, and with a similar normal; from 0 to 255. */
LANES_INLINE void
averagingWeights (const StepControl& control, const BlockRows& rows, int first)
{
  const std::uint32_t* own = rows.neighbors + first;
  std::uint8_t* weights = control.weights + rows.begin + first;
  const Lanes3 own_normal = load3 (control.nodes.normals, own);
  const LocalPoints local (control.nodes, rows, own);
  for (std::size_t j = 0; j < local.count; ++j) {
    Lanes3 normal = load3 (control.nodes.normals, own + 16 * j);
    const Lanes x = 1 - turn (normal, own_normal, control.oriented);
    const Lanes exponent = 0.5f * dot (local.at[j], local.at[j]) + x * 2.0408163f; // |n_i - n_j|^2 / (2 .7^2)
    const Lanes weight = x == x ? local.one[j] * bell (exponent) : splat (0);
    const Mask rounded = __builtin_convertvector(weight * 255.0f + 0.5f, Mask);
    const Bytes bytes = __builtin_convertvector(rounded, Bytes);
    std::memcpy (weights + 16 * j, &bytes, sizeof bytes);
  }
}

/** One averaging of the risks over the neighbourhoods. */
LANES_INLINE void
averageRisks (const StepControl& control, const BlockRows& rows, int first)
{
  const std::uint32_t* own = rows.neighbors + first;
  const std::uint8_t* weights = control.weights + rows.begin + first;
  const std::size_t count = rows.length < max_fit_neighbors ? rows.length : max_fit_neighbors;
  Lanes sum_product = {}, sum_size = {}, sum = {};
  for (std::size_t j = 0; j < count; ++j) {
    const Lanes weight = __builtin_convertvector(load<Bytes> (weights + 16 * j), Lanes);
    const Lanes3 risk = load3 (control.risks, own + 16 * j);
    sum += weight;
    sum_product += weight * risk.x;
    sum_size += weight * risk.y;
  }
  const Lanes scale = sum > 0 ? 1 / sum : splat (0);
  store3 (control.averaged, own, {scale * sum_product, scale * sum_size, Lanes {}});
}

/** Takes the share of the proposed step that the risk allows: with a and s the averages of stepRisks, the mean square of
  * the step is q = (pi / 2) s^2 (of a Gaussian, from its mean size: heavy tails count less), and the share is
  * (gain - a) / q within [0, 1]. */
LANES_INLINE void
takeSteps (const StepControl& control, const BlockRows& rows, int first)
{
  const std::uint32_t* own = rows.neighbors + first;
  const Lanes3 risk = load3 (control.risks, own), offset = load3 (control.nodes.offset, own);
  const Lanes q = 1.57079633f * (risk.y * risk.y);
  const Lanes share = q > 0 ? minimum (maximum ((control.gain - risk.x) / q, splat (0)), splat (1)) : splat (0);
  const Lanes3 start = load3 (control.start, own);
  const Lanes3 step = load3 (control.proposed, own) - offset;
  store3 (control.taken, own, start + capped ((offset + share * step) - start, control.max_displacement));
}
} // namespace PCL_NORMAL_SMOOTHING_ISA
} // namespace core
} // namespace pcl_normal_smoothing
