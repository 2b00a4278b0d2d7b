// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lanes.h"

#include <pcl_normal_smoothing/core/kernels.h>

#if defined(__AVX512F__)
#include <immintrin.h>
#endif

namespace pcl_normal_smoothing
{
namespace core
{
namespace PCL_NORMAL_SMOOTHING_ISA
{
/** Squared distances of some candidates: ((dx^2 + dy^2) + dz^2) in float, as FLANN's. */
LANES_INLINE Lanes
squaredDistances (const Candidates& candidates, const CandidateQuery& query, std::size_t first)
{
  Lanes difference[3];
  for (int d = 0; d < 3; ++d) {
    difference[d] = load<Lanes> (candidates.base[d] + first) - query.base[d];
    if (candidates.offset[0] != nullptr)
      difference[d] += load<Lanes> (candidates.offset[d] + first) - query.offset[d];
  }
  return (difference[0] * difference[0] + difference[1] * difference[1]) + difference[2] * difference[2];
}

/** The candidates that are not farther than the bound, and their squared distances. */
LANES_INLINE std::size_t
selectNear (const Candidates& candidates, const CandidateQuery& query, float* sq_dists, std::uint32_t* selected)
{
  std::size_t size = 0;
  for (std::size_t first = 0; first < candidates.count; first += lane_count) {
    const Lanes of_lanes = squaredDistances (candidates, query, first);
#if defined(__AVX512F__)
    const __m512i numbers = _mm512_add_epi32 (_mm512_set1_epi32 (static_cast<int> (first)),
                                              _mm512_setr_epi32 (0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15));
    const auto in_range = static_cast<__mmask16> (
        candidates.count - first >= 16 ? 0xffff : (1u << (candidates.count - first)) - 1);
    const __mmask16 near = _mm512_mask_cmp_ps_mask (in_range, (__m512) of_lanes, _mm512_set1_ps (query.sq_bound), _CMP_LE_OQ);
    _mm512_storeu_si512 (selected + size, _mm512_maskz_compress_epi32 (near, numbers));
    _mm512_storeu_ps (sq_dists + size, _mm512_maskz_compress_ps (near, (__m512) of_lanes));
    size += static_cast<std::size_t> (__builtin_popcount (near));
#else
    for (std::size_t lane = 0; lane < lane_count && first + lane < candidates.count; ++lane) {
      selected[size] = static_cast<std::uint32_t> (first + lane); // without a branch: which pass is as good as random
      sq_dists[size] = of_lanes[lane];
      size += of_lanes[lane] <= query.sq_bound;
    }
#endif
  }
  return size;
}

/** How many of \a count keys are smaller than each of them.
  * \return whether all keys differ: where two are equal, no key has the rank of the second, and the ranks sum up to less */
LANES_INLINE bool
rankKeys (const float* keys, std::size_t count, std::int32_t* ranks)
{
  for (std::size_t i = 0; i < count; i += lane_count) {
    const Lanes own = load<Lanes> (keys + i);
    Mask rank = {};
    for (std::size_t j = 0; j < count; ++j)
      rank -= (splat (keys[j]) < own); // a mask is -1 where it holds
    std::memcpy (ranks + i, &rank, sizeof rank);
  }
  std::size_t sum = 0;
  for (std::size_t i = 0; i < count; ++i)
    sum += static_cast<std::size_t> (ranks[i]);
  return 2 * sum == count * (count - 1);
}
} // namespace PCL_NORMAL_SMOOTHING_ISA
} // namespace core
} // namespace pcl_normal_smoothing
