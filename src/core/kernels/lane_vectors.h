// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lanes.h"

#include <pcl_normal_smoothing/core/block_size.h>

namespace pcl_normal_smoothing
{
namespace core
{
namespace PCL_NORMAL_SMOOTHING_ISA
{
// Within every four lanes: lanes p, q of a, then r, s of b; a's are numbered 0-3, b's 4-7.
#if defined(__AVX512F__)
#define LANES_SHUFFLE(a, b, p, q, r, s)                                                                            \
  __builtin_shufflevector (a, b, p, q, r + 12, s + 12, p + 4, q + 4, r + 16, s + 16, p + 8, q + 8, r + 20, s + 20, \
                           p + 12, q + 12, r + 24, s + 24)
#elif defined(__AVX2__)
#define LANES_SHUFFLE(a, b, p, q, r, s) __builtin_shufflevector (a, b, p, q, r + 4, s + 4, p + 4, q + 4, r + 8, s + 8)
#else
#define LANES_SHUFFLE(a, b, p, q, r, s) __builtin_shufflevector (a, b, p, q, r, s)
#endif

/** Transposes vectors of two or three floats: reads four floats from each start, whatever the last ones are. That
  * takes half the time of gathering single floats. */
class Transposition
{
public:
  /** Reads vectors 4 * \a row to 4 * \a row + 3. */
  template <int row>
  LANES_INLINE void
  put (const float* vectors, const std::size_t (&begin)[4])
  {
    insert<row> (a_, vectors + begin[0]);
    insert<row> (b_, vectors + begin[1]);
    insert<row> (c_, vectors + begin[2]);
    insert<row> (d_, vectors + begin[3]);
  }

  LANES_INLINE Lanes3
  three () const
  {
    const Lanes xy_ab = LANES_SHUFFLE (a_, b_, 0, 1, 4, 5), xy_cd = LANES_SHUFFLE (c_, d_, 0, 1, 4, 5);
    const Lanes z_ab = LANES_SHUFFLE (a_, b_, 2, 3, 6, 7), z_cd = LANES_SHUFFLE (c_, d_, 2, 3, 6, 7);
    return {LANES_SHUFFLE (xy_ab, xy_cd, 0, 2, 4, 6), LANES_SHUFFLE (xy_ab, xy_cd, 1, 3, 5, 7),
            LANES_SHUFFLE (z_ab, z_cd, 0, 2, 4, 6)};
  }

  LANES_INLINE Lanes2
  two () const
  {
    const Lanes ab = LANES_SHUFFLE (a_, b_, 0, 1, 4, 5), cd = LANES_SHUFFLE (c_, d_, 0, 1, 4, 5);
    return {LANES_SHUFFLE (ab, cd, 0, 2, 4, 6), LANES_SHUFFLE (ab, cd, 1, 3, 5, 7)};
  }

private:
  /** Loads from memory straight into place: compilers would insert a shuffle and a copy. */
  template <int row>
  LANES_INLINE static void
  insert (Lanes& fours, const float* from)
  {
#if defined(__AVX512F__)
    const __m128 four = _mm_loadu_ps (from);
    fours = (Lanes) (row == 0 ? _mm512_castps128_ps512 (four) : _mm512_insertf32x4 ((__m512) fours, four, row));
#elif defined(__AVX2__)
    const __m128 four = _mm_loadu_ps (from);
    fours = (Lanes) (row == 0 ? _mm256_castps128_ps256 (four) : _mm256_insertf128_ps ((__m256) fours, four, row));
#else
    fours = load<Lanes> (from);
#endif
  }

  Lanes a_, b_, c_, d_; // the first of every four vectors, the second, and so on
};

/** Loads the vectors named by \a index from each array into its transposition. All arrays in one call, so that every
  * index is read once. */
template <int dimension, int row = 0, typename... Pairs>
LANES_INLINE void
transpose (const std::uint32_t* index, Pairs&&... pairs)
{
  const std::size_t begin[4] = {dimension * std::size_t (index[4 * row]), dimension * std::size_t (index[4 * row + 1]),
                                dimension * std::size_t (index[4 * row + 2]),
                                dimension * std::size_t (index[4 * row + 3])};
  (pairs.to.template put<row> (pairs.vectors, begin), ...);
  if constexpr (4 * (row + 1) < lane_count)
    transpose<dimension, row + 1> (index, pairs...);
}

struct Transposed
{
  const float* vectors;
  Transposition& to;
};

/** The vectors of three floats named by \a index. Reads four bytes past each. */
LANES_INLINE Lanes3
load3 (const float* vectors, const std::uint32_t* index)
{
  Transposition of_vectors;
  transpose<3> (index, Transposed {vectors, of_vectors});
  return of_vectors.three ();
}

/** As above; zeros if \a vectors is null. */
LANES_INLINE Lanes3
load3OrZero (const float* vectors, const std::uint32_t* index)
{
  return vectors != nullptr ? load3 (vectors, index) : Lanes3 {};
}

/** The vectors of two floats named by \a index. Reads eight bytes past each. */
LANES_INLINE Lanes2
load2 (const float* vectors, const std::uint32_t* index)
{
  Transposition of_vectors;
  transpose<2> (index, Transposed {vectors, of_vectors});
  return of_vectors.two ();
}

/** The numbers named by \a index. */
LANES_INLINE Lanes
load1 (const float* numbers, const std::uint32_t* index)
{
  Lanes value;
  for (int lane = 0; lane < lane_count; ++lane)
    value[lane] = numbers[index[lane]];
  return value;
}

/** As above; ones if \a numbers is null. */
LANES_INLINE Lanes
load1OrOne (const float* numbers, const std::uint32_t* index)
{
  return numbers != nullptr ? load1 (numbers, index) : splat (1);
}

/** As load3, but reads nothing past the vectors: for arrays that another thread may be writing. */
LANES_INLINE Lanes3
load3Alone (const float* vectors, const std::uint32_t* index)
{
  Lanes3 value;
  for (int lane = 0; lane < lane_count; ++lane) {
    const float* from = vectors + 3 * std::size_t (index[lane]);
    value.x[lane] = from[0];
    value.y[lane] = from[1];
    value.z[lane] = from[2];
  }
  return value;
}

LANES_INLINE void
store3 (float* vectors, const std::uint32_t* index, Lanes3 value)
{
  for (int lane = 0; lane < lane_count; ++lane) {
    float* to = vectors + 3 * std::size_t (index[lane]);
    to[0] = value.x[lane];
    to[1] = value.y[lane];
    to[2] = value.z[lane];
  }
}

LANES_INLINE void
store2 (float* vectors, const std::uint32_t* index, Lanes2 value)
{
  for (int lane = 0; lane < lane_count; ++lane) {
    float* to = vectors + 2 * std::size_t (index[lane]);
    to[0] = value.x[lane];
    to[1] = value.y[lane];
  }
}

LANES_INLINE void
store1 (float* numbers, const std::uint32_t* index, Lanes value)
{
  for (int lane = 0; lane < lane_count; ++lane)
    numbers[index[lane]] = value[lane];
}

/** The points p = base + offset of a block's lanes, and the differences from them to other points. */
class Points
{
public:
  LANES_INLINE
  Points (const float* base, const float* offset, const std::uint32_t* own)
  : base_ (base), offset_ (offset), own_base_ (load3 (base, own)), own_offset_ (load3OrZero (offset, own))
  {}

  LANES_INLINE Lanes3
  difference (const std::uint32_t* index) const
  {
    Transposition base, offset;
    if (offset_ == nullptr) {
      transpose<3> (index, Transposed {base_, base});
      return base.three () - own_base_;
    }
    transpose<3> (index, Transposed {base_, base}, Transposed {offset_, offset});
    return (base.three () - own_base_) + (offset.three () - own_offset_);
  }

  /** \param[out] vector those named by \a index among \a vectors */
  LANES_INLINE Lanes3
  difference (const std::uint32_t* index, const float* vectors, Lanes3& vector) const
  {
    Transposition base, offset, other;
    if (offset_ == nullptr) {
      transpose<3> (index, Transposed {base_, base}, Transposed {vectors, other});
      vector = other.three ();
      return base.three () - own_base_;
    }
    transpose<3> (index, Transposed {base_, base}, Transposed {offset_, offset}, Transposed {vectors, other});
    vector = other.three ();
    return (base.three () - own_base_) + (offset.three () - own_offset_);
  }

private:
  const float* base_;
  const float* offset_;
  Lanes3 own_base_;
  Lanes3 own_offset_;
};

/** Passed to isOther as the node itself: then every neighbour counts as another. */
constexpr std::uint32_t no_nodes[block_size] = {~0u, ~0u, ~0u, ~0u, ~0u, ~0u, ~0u, ~0u,
                                                ~0u, ~0u, ~0u, ~0u, ~0u, ~0u, ~0u, ~0u};

/** All ones in the lanes whose neighbour is not the node itself: a row shorter than its block's is padded with the
  * node. */
LANES_INLINE Mask
isOther (const std::uint32_t* neighbor, const std::uint32_t* own)
{
  return load<Mask> (neighbor) != load<Mask> (own);
}
} // namespace PCL_NORMAL_SMOOTHING_ISA
} // namespace core
} // namespace pcl_normal_smoothing
