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
/** Squared distances of all candidates: ((dx^2 + dy^2) + dz^2) in float, as FLANN's. */
LANES_INLINE void
squaredDistances (const Candidates& candidates, const CandidateQuery& query, float* sq_dists)
{
  for (std::size_t i = 0; i < candidates.count; i += lane_count) {
    Lanes difference[3];
    for (int d = 0; d < 3; ++d) {
      difference[d] = load<Lanes> (candidates.base[d] + i) - query.base[d];
      if (candidates.offset[0] != nullptr)
        difference[d] += load<Lanes> (candidates.offset[d] + i) - query.offset[d];
    }
    store (sq_dists + i, (difference[0] * difference[0] + difference[1] * difference[1]) + difference[2] * difference[2]);
  }
}

/** Numbers of the candidates that are not farther than the bound. */
LANES_INLINE std::size_t
selectNear (const float* sq_dists, std::size_t count, float sq_bound, std::uint32_t* selected)
{
  std::size_t size = 0;
  for (std::size_t i = 0; i < count; ++i) { // without a branch: which pass is as good as random
    selected[size] = static_cast<std::uint32_t> (i);
    size += sq_dists[i] <= sq_bound;
  }
  return size;
}

/** How many of \a count keys are smaller than each of them. \a keys is filled up to whole lanes. */
LANES_INLINE void
rankKeys (const float* keys, std::size_t count, std::int32_t* ranks)
{
  for (std::size_t i = 0; i < count; i += lane_count) {
    const Lanes own = load<Lanes> (keys + i);
    Mask rank = {};
    for (std::size_t j = 0; j < count; ++j)
      rank -= (splat (keys[j]) < own); // a mask is -1 where it holds
    std::memcpy (ranks + i, &rank, sizeof rank);
  }
}
} // namespace PCL_NORMAL_SMOOTHING_ISA
} // namespace core
} // namespace pcl_normal_smoothing
