// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "local_points.h"

namespace pcl_normal_smoothing
{
namespace core
{
namespace PCL_NORMAL_SMOOTHING_ISA
{
/** The rows of the lanes' neighbours, each with its own length. */
class NextRows
{
public:
  LANES_INLINE
  NextRows (const FarRowsStep& step, const std::uint32_t* neighbor)
  {
    for (int lane = 0; lane < lane_count; ++lane) {
      first_[lane] = step.block_rows[neighbor[lane] / block_size] + neighbor[lane] % block_size;
      last_[lane] = step.row_lengths[neighbor[lane]] - 1;
    }
  }

  /** \param[out] index the neighbours at the given ranks plus \a offset \param[out] there those ranks, clamped to
    * the range from 1 to the last neighbour's */
  LANES_INLINE void
  at (const std::int32_t* ranks, std::int32_t offset, std::uint32_t* index, std::int32_t* there) const
  {
    for (int lane = 0; lane < lane_count; ++lane) {
      const std::int32_t rank = ranks[lane] + offset, wanted = rank > 1 ? rank : 1;
      there[lane] = wanted < last_[lane] ? wanted : last_[lane];
      index[lane] = first_[lane][block_size * there[lane]];
    }
  }

private:
  const std::uint32_t* first_[lane_count];
  std::int32_t last_[lane_count];
};

/** Writes the ranks that make up the lanes' far rows (see core/rounds/far_rows.h). A node occurs in its own row only
  * as padding at the end, which the kernels rely on. */
LANES_INLINE void
findFarRows (const FarRowsStep& step, const BlockRows& rows, int first)
{
  // The continuation is about as long as the step to the neighbour, so its rank there is similar: try ranks at most 2
  // off.
  constexpr std::int32_t rank_window = 2;
  const std::uint32_t* own = rows.neighbors + first;
  const Points points (step.nodes.base, step.nodes.offset, own);
  const std::size_t block = own[0] / block_size;
  std::uint8_t* ranks = step.ranks + block_size * far_row_length * block + first;
  std::uint32_t lengths[lane_count];
  for (int lane = 0; lane < lane_count; ++lane)
    lengths[lane] = step.row_lengths[own[lane]];
  for (std::size_t slot = 0; slot < far_row_length; ++slot) {
    std::int32_t seeds[lane_count];
    std::uint32_t neighbor[lane_count];
    for (int lane = 0; lane < lane_count; ++lane) {
      seeds[lane] = static_cast<std::int32_t> (seedRank (slot, lengths[lane]));
      neighbor[lane] = own[block_size * seeds[lane] + lane];
    }
    const Lanes3 end = splat (2) * points.difference (neighbor);
    const NextRows next (step, neighbor);
    Lanes least = splat (__builtin_inff ());
    Mask nearest = {};
    for (std::int32_t offset = -rank_window; offset <= rank_window; ++offset) {
      std::uint32_t index[lane_count];
      std::int32_t there[lane_count];
      next.at (seeds, offset, index, there);
      const Lanes3 off = points.difference (index) - end;
      const Lanes distance = dot (off, off);
      const Mask is_nearer = (distance < least) & isOther (index, own);
      least = is_nearer ? distance : least;
      nearest = is_nearer ? load<Mask> (there) : nearest;
    }
    nearest = isOther (neighbor, own) ? nearest : Mask {};
    const Bytes bytes = __builtin_convertvector(nearest, Bytes);
    std::memcpy (ranks + block_size * slot, &bytes, sizeof bytes);
  }
}
} // namespace PCL_NORMAL_SMOOTHING_ISA
} // namespace core
} // namespace pcl_normal_smoothing
