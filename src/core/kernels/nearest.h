// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lanes.h"

#include "../kernels.h"

namespace pcl_normal_smoothing
{
namespace core
{
namespace PCL_NORMAL_SMOOTHING_ISA
{
/** Squared distances of the candidates from \a first on: ((dx^2 + dy^2) + dz^2) in float, as in FLANN. */
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

/** Output for the candidates that are near, appended one after another; has room for a whole vector beyond the last. */
struct NearCandidates
{
  float* sq_dists;
  std::uint32_t* numbers;
  std::size_t size;
};

// appendNear, for every instruction set: appends those of the first \a count lanes that are within the bound. The
// candidate of lane 0 has the number \a first.
#if defined(__AVX512F__)

LANES_INLINE void
appendNear (Lanes sq_dists, float sq_bound, std::size_t first, std::size_t count, NearCandidates& near)
{
  const __m512i numbers = _mm512_add_epi32 (_mm512_set1_epi32 (static_cast<int> (first)),
                                            _mm512_setr_epi32 (0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15));
  const auto in_range = static_cast<__mmask16> ((1u << count) - 1);
  const __mmask16 are_near =
      _mm512_mask_cmp_ps_mask (in_range, (__m512) sq_dists, _mm512_set1_ps (sq_bound), _CMP_LE_OQ);
  _mm512_storeu_si512 (near.numbers + near.size, _mm512_maskz_compress_epi32 (are_near, numbers));
  _mm512_storeu_ps (near.sq_dists + near.size, _mm512_maskz_compress_ps (are_near, (__m512) sq_dists));
  near.size += static_cast<std::size_t> (__builtin_popcount (are_near));
}

#elif defined(__AVX2__)

/** For every set of lanes, their numbers in ascending order, one per byte, starting with the lowest byte. */
struct LanesOfSets
{
  std::uint64_t lanes[256] = {};

  constexpr LanesOfSets ()
  {
    for (unsigned set = 0; set < 256; ++set)
      for (unsigned lane = 0, shift = 0; lane < 8; ++lane)
        if ((set >> lane & 1) != 0) {
          lanes[set] |= std::uint64_t {lane} << shift;
          shift += 8;
        }
  }
};
constexpr LanesOfSets lanes_of_sets;

LANES_INLINE void
appendNear (Lanes sq_dists, float sq_bound, std::size_t first, std::size_t count, NearCandidates& near)
{
  const __m256 are_near = _mm256_cmp_ps ((__m256) sq_dists, _mm256_set1_ps (sq_bound), _CMP_LE_OQ);
  const unsigned set = static_cast<unsigned> (_mm256_movemask_ps (are_near)) & ((1u << count) - 1);
  const __m256i lanes = _mm256_cvtepu8_epi32 (_mm_loadl_epi64 ((const __m128i*) (lanes_of_sets.lanes + set)));
  _mm256_storeu_si256 ((__m256i*) (near.numbers + near.size),
                       _mm256_add_epi32 (lanes, _mm256_set1_epi32 (static_cast<int> (first))));
  _mm256_storeu_ps (near.sq_dists + near.size, _mm256_permutevar8x32_ps ((__m256) sq_dists, lanes));
  near.size += static_cast<std::size_t> (__builtin_popcount (set));
}

#else

LANES_INLINE void
appendNear (Lanes sq_dists, float sq_bound, std::size_t first, std::size_t count, NearCandidates& near)
{
  for (std::size_t lane = 0; lane < count; ++lane) { // branchless: which lanes pass is unpredictable
    near.numbers[near.size] = static_cast<std::uint32_t> (first + lane);
    near.sq_dists[near.size] = sq_dists[lane];
    near.size += sq_dists[lane] <= sq_bound;
  }
}

#endif

/** The candidates within the bound, and their squared distances. The first two arguments are passed by value:
  * otherwise the compiler must assume that the stores may change them, and reload them for every vector. */
LANES_INLINE std::size_t
selectNear (const Candidates candidates, const CandidateQuery query, float* sq_dists, std::uint32_t* selected)
{
  NearCandidates near {sq_dists, selected, 0};
  std::size_t first = 0;
  for (; first + lane_count <= candidates.count; first += lane_count)
    appendNear (squaredDistances (candidates, query, first), query.sq_bound, first, lane_count, near);
  if (first < candidates.count)
    appendNear (squaredDistances (candidates, query, first), query.sq_bound, first, candidates.count - first, near);
  return near.size;
}

/** For each of \a count keys, counts the smaller ones.
  * \return whether all keys differ: if two are equal, one rank is missing, and the ranks sum up to less */
LANES_INLINE bool
rankKeys (const float* keys, std::size_t count, std::int32_t* ranks)
{
  for (std::size_t i = 0; i < count; i += lane_count) {
    const Lanes own = load<Lanes> (keys + i);
    Mask of_even = {}, of_odd = {}; // two counters, so that additions need not wait for each other
    std::size_t j = 0;
    for (; j + 2 <= count; j += 2) {
      of_even -= (splat (keys[j]) < own); // a mask is -1 where it is set
      of_odd -= (splat (keys[j + 1]) < own);
    }
    if (j < count)
      of_even -= (splat (keys[j]) < own);
    const Mask rank = of_even + of_odd;
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
