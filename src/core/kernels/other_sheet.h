// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "normal_filter.h"

namespace pcl_normal_smoothing
{
namespace core
{
namespace PCL_NORMAL_SMOOTHING_ISA
{
/** Counts the neighbours on another sheet: those with a similar normal, up to its sign, and too far from the mean of
  * both tangent planes. */
LANES_INLINE void
countOthers (const OtherSheetCount& task, const BlockRows& rows, int first)
{
  const std::uint32_t* own = rows.neighbors + first;
  const Points points (task.nodes.base, task.nodes.offset, own);
  const Lanes3 own_normal = load3 (task.nodes.normals, own);
  Lanes others = {};
  for (std::size_t j = 1; j < rows.length; ++j) {
    Lanes3 normal;
    const Lanes3 difference = points.difference (own + block_size * j, task.nodes.normals, normal);
    const Lanes cosine = dot (own_normal, normal);
    const Lanes height = 0.5f * (dot (own_normal, difference) + turned (dot (normal, difference), cosine, false));
    Mask other = (absolute (cosine) > task.min_cosine) &
                 (height * height > task.sq_distance + task.sq_slope * dot (difference, difference));
    if (task.oriented)
      other |= cosine < 0;
    others += other ? splat (1) : splat (0);
  }
  store1 (task.others, own, others);
}
} // namespace PCL_NORMAL_SMOOTHING_ISA
} // namespace core
} // namespace pcl_normal_smoothing
