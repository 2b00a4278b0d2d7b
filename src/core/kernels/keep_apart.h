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
// The constants of keepApart. Lengths are in spacings.
namespace apart
{
constexpr std::size_t row_length = 16;  // of the points that may be too close
constexpr std::size_t spacing_rank = 8; // the spacing follows from the eighth
constexpr std::size_t edge_rank = 5;    // as many neighbours show an edge
constexpr float min_cosine = 0.5f;      // of their normals to the point's; below, one lies across an edge
constexpr float least_distance = 0.5f;  // closer points move apart
constexpr float share = 0.5f;           // of what is missing; the other point moves the rest
constexpr float max_step = 0.25f;
constexpr float least_sq_along = 0.01f; // share of the squared distance: below, it has no direction along the surface
} // namespace apart

/** Moves the lanes' points along the surface, away from those that came closer than they were, and closer than half
  * the spacing: by half of what is missing, as the other point moves the rest. Beside an edge nothing moves: along
  * one of its planes a point would leave the other. */
LANES_INLINE void
keepApart (const KeepApartStep& step, const BlockRows& rows, int first)
{
  const std::uint32_t* own = rows.neighbors + first;
  const Points now (step.nodes.base, step.nodes.offset, own), before (step.nodes.base, step.start, own);
  const Lanes3 normal = load3 (step.nodes.normals, own);
  const std::size_t count = rows.length < apart::row_length ? rows.length : apart::row_length;
  Lanes sq_reach = {}; // of the eighth point of the row, or of the last of a shorter one
  for (std::size_t j = 1; j < (count < apart::spacing_rank ? count : apart::spacing_rank); ++j) {
    const Lanes3 way = before.difference (own + block_size * j);
    sq_reach = isOther (own + block_size * j, own) ? dot (way, way) : sq_reach;
  }
  const Lanes spacing = float (spacing_of_eighth) * squareRoot (sq_reach);
  Mask may_move = normal.x == normal.x;
  Lanes3 sum = {};
  for (std::size_t j = 1; j < count; ++j) {
    const std::uint32_t* index = own + block_size * j;
    if (j <= apart::edge_rank) {
      const Lanes cosine = dot (normal, load3 (step.nodes.normals, index));
      may_move = may_move & (similarity (cosine, step.oriented) > apart::min_cosine);
    }
    const Lanes3 way = now.difference (index), way_before = before.difference (index);
    const Lanes wanted = minimum (squareRoot (dot (way_before, way_before)), apart::least_distance * spacing);
    const Lanes missing = maximum (wanted - squareRoot (dot (way, way)), splat (0));
    const Lanes3 along = way - dot (way, normal) * normal;
    const Lanes sq_length = dot (along, along);
    const Mask has_direction = sq_length > apart::least_sq_along * dot (way, way);
    sum = sum - (has_direction ? apart::share * missing / squareRoot (sq_length) : splat (0)) * along;
  }
  const Lanes length = squareRoot (dot (sum, sum)), limit = apart::max_step * spacing;
  may_move = may_move & (length > 0);
  const Lanes3 offset = load3OrZero (step.nodes.offset, own), start = load3OrZero (step.start, own);
  const Lanes3 moved = offset + (length > limit ? limit / length : splat (1)) * sum;
  store3 (step.moved, own, choose (may_move, start + capped (moved - start, step.max_displacement), offset));
}
} // namespace PCL_NORMAL_SMOOTHING_ISA
} // namespace core
} // namespace pcl_normal_smoothing
