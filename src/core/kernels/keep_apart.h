// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../spacing.h"
#include "local_points.h"
#include "normal_filter.h"

namespace pcl_normal_smoothing
{
namespace core
{
namespace PCL_NORMAL_SMOOTHING_ISA
{
/** Moves the lanes' points along the surface, away from those that came closer than they were, and closer than half
  * the spacing: by half of what is missing, as the other point moves the rest. Beside an edge nothing moves: along
  * one of its planes a point would leave the other. */
LANES_INLINE void
keepApart (const KeepApartStep& step, const BlockRows& rows, int first)
{
  constexpr std::size_t max_near = 16, nearest = 8, beside = 5;
  const std::uint32_t* own = rows.neighbors + first;
  const Points now (step.nodes.base, step.nodes.offset, own), before (step.nodes.base, step.start, own);
  const Lanes3 normal = load3 (step.nodes.normals, own);
  const std::size_t count = rows.length < max_near ? rows.length : max_near;
  Lanes sq_reach = {}; // of the eighth point of the row, or of the last of a shorter one
  for (std::size_t j = 1; j < (count < nearest ? count : nearest); ++j) {
    const Lanes3 way = before.difference (own + block_size * j);
    sq_reach = isOther (own + block_size * j, own) ? dot (way, way) : sq_reach;
  }
  const Lanes spacing = float (spacing_of_eighth) * squareRoot (sq_reach);
  Mask may_move = normal.x == normal.x;
  Lanes3 sum = {};
  for (std::size_t j = 1; j < count; ++j) {
    const std::uint32_t* index = own + block_size * j;
    if (j <= beside) {
      const Lanes cosine = dot (normal, load3 (step.nodes.normals, index));
      may_move = may_move & (similarity (cosine, step.oriented) > 0.5f);
    }
    const Lanes3 way = now.difference (index), way_before = before.difference (index);
    const Lanes wanted = minimum (squareRoot (dot (way_before, way_before)), 0.5f * spacing);
    const Lanes missing = maximum (wanted - squareRoot (dot (way, way)), splat (0));
    const Lanes3 along = way - dot (way, normal) * normal;
    const Lanes sq_length = dot (along, along); // a point right above or below gives no direction along the surface
    sum = sum - (sq_length > 0.01f * dot (way, way) ? 0.5f * missing / squareRoot (sq_length) : splat (0)) * along;
  }
  const Lanes length = squareRoot (dot (sum, sum)), limit = 0.25f * spacing;
  may_move = may_move & (length > 0);
  const Lanes3 offset = load3OrZero (step.nodes.offset, own), start = load3OrZero (step.start, own);
  const Lanes3 moved = offset + (length > limit ? limit / length : splat (1)) * sum;
  store3 (step.moved, own, choose (may_move, start + capped (moved - start, step.max_displacement), offset));
}
} // namespace PCL_NORMAL_SMOOTHING_ISA
} // namespace core
} // namespace pcl_normal_smoothing
