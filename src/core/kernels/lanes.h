// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

// Files that include this are compiled once for every instruction set, each into a namespace of its own. They hold plain
// arithmetic on arrays and nothing of Eigen or the standard library, so that no code for a newer machine leaks into
// functions that all share.
#ifndef PCL_NORMAL_SMOOTHING_ISA
#error "compile the kernels with PCL_NORMAL_SMOOTHING_ISA set to a namespace"
#endif

#define LANES_INLINE inline __attribute__ ((always_inline))
#define LANES_LAMBDA __attribute__ ((always_inline))

namespace pcl_normal_smoothing
{
namespace core
{
namespace PCL_NORMAL_SMOOTHING_ISA
{
#if defined(__AVX512F__)
constexpr int lane_count = 16;
#elif defined(__AVX2__)
constexpr int lane_count = 8;
#else
constexpr int lane_count = 4;
#endif

/** One number of several points, a point a lane. Every lane does what a scalar would, so the result does not depend on
  * the number of lanes. Comparisons give a Mask, and mask ? a : b chooses lane by lane. */
typedef float Lanes __attribute__ ((vector_size (4 * lane_count), aligned (4)));
typedef std::int32_t Mask __attribute__ ((vector_size (4 * lane_count), aligned (4)));
typedef std::uint8_t Bytes __attribute__ ((vector_size (lane_count), aligned (1)));
typedef float Four __attribute__ ((vector_size (16), aligned (4)));

struct Lanes3
{
  Lanes x, y, z;
};

LANES_INLINE Lanes
splat (float value)
{
  return Lanes {} + value;
}

template <typename T>
LANES_INLINE T
load (const void* from)
{
  T value;
  std::memcpy (&value, from, sizeof value);
  return value;
}

LANES_INLINE void
store (float* to, Lanes value)
{
  std::memcpy (to, &value, sizeof value);
}

LANES_INLINE Lanes
minimum (Lanes a, Lanes b)
{
  return a < b ? a : b;
}

LANES_INLINE Lanes
maximum (Lanes a, Lanes b)
{
  return a > b ? a : b;
}

LANES_INLINE Lanes
absolute (Lanes a)
{
  return (Lanes) ((Mask) a & 0x7fffffff);
}

/** a where sign >= +0, -a where its sign bit is set. */
LANES_INLINE Lanes
withSignOf (Lanes a, Lanes sign)
{
  return (Lanes) ((Mask) a ^ ((Mask) sign & INT32_MIN));
}

LANES_INLINE Lanes
squareRoot (Lanes a)
{
  Lanes root;
  for (int lane = 0; lane < lane_count; ++lane)
    root[lane] = __builtin_sqrtf (a[lane]);
  return root;
}

LANES_INLINE Lanes3
operator+ (Lanes3 a, Lanes3 b)
{
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

LANES_INLINE Lanes3
operator- (Lanes3 a, Lanes3 b)
{
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

LANES_INLINE Lanes3
operator* (Lanes s, Lanes3 a)
{
  return {s * a.x, s * a.y, s * a.z};
}

LANES_INLINE Lanes
dot (Lanes3 a, Lanes3 b)
{
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

/** exp (-x) for x >= 0 within 2e-7 relative, 0 from x = 87 on; NaN for NaN. */
LANES_INLINE Lanes
expOfMinus (Lanes x)
{
  // exp (-x) = 2^n exp (r), n = round (-x / ln 2), |r| <= ln 2 / 2; ln 2 in two parts, the first exact times n.
  constexpr float log2_e = 1.44269504f, ln2_high = 0.693359375f, ln2_low = -2.12194440e-4f;
  constexpr float round_to_integer = 12582912.0f; // 1.5 * 2^23: adding it leaves the integer in the low bits
  const Lanes clamped = x > 87.0f ? splat (87.0f) : x;
  const Lanes shifted = -clamped * log2_e + round_to_integer;
  const Lanes n = shifted - round_to_integer;
  const Lanes r = (-clamped - n * ln2_high) - n * ln2_low;
  Lanes polynomial = splat (1.0f / 5040);
  constexpr float coefficients[] = {1.0f / 720, 1.0f / 120, 1.0f / 24, 1.0f / 6, 0.5f, 1.0f, 1.0f};
  for (const float coefficient : coefficients)
    polynomial = polynomial * r + coefficient;
  const Lanes power = (Lanes) (((Mask) shifted + 127) << 23); // the exponent field of 2^n
  return x >= 87.0f ? splat (0.0f) : polynomial * power;
}

// Of every four lanes: two of a, two of b, as they are numbered within the four (b from 4 on).
#if defined(__AVX512F__)
#define LANES_SHUFFLE(a, b, p, q, r, s)                                                                            \
  __builtin_shufflevector (a, b, p, q, r + 12, s + 12, p + 4, q + 4, r + 16, s + 16, p + 8, q + 8, r + 20, s + 20, \
                           p + 12, q + 12, r + 24, s + 24)
#elif defined(__AVX2__)
#define LANES_SHUFFLE(a, b, p, q, r, s) __builtin_shufflevector (a, b, p, q, r + 4, s + 4, p + 4, q + 4, r + 8, s + 8)
#else
#define LANES_SHUFFLE(a, b, p, q, r, s) __builtin_shufflevector (a, b, p, q, r, s)
#endif

/** Four numbers from the begin of the vectors \a index[0], index[4] ..., one after the other. */
template <int dimension>
LANES_INLINE Lanes
loadFours (const float* vectors, const std::uint32_t* index)
{
  const auto four = [&] (int i) LANES_LAMBDA { return load<Four> (vectors + dimension * std::size_t (index[i])); };
#if defined(__AVX512F__)
  return __builtin_shufflevector (__builtin_shufflevector (four (0), four (4), 0, 1, 2, 3, 4, 5, 6, 7),
                                  __builtin_shufflevector (four (8), four (12), 0, 1, 2, 3, 4, 5, 6, 7), 0, 1, 2, 3, 4,
                                  5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
#elif defined(__AVX2__)
  return __builtin_shufflevector (four (0), four (4), 0, 1, 2, 3, 4, 5, 6, 7);
#else
  return four (0);
#endif
}

/** The vectors of three floats that \a index names. Reads four bytes past each: whole loads and a transposition cost half
  * of what gathering single numbers does. */
LANES_INLINE Lanes3
load3 (const float* vectors, const std::uint32_t* index)
{
  const Lanes a = loadFours<3> (vectors, index), b = loadFours<3> (vectors, index + 1),
              c = loadFours<3> (vectors, index + 2), d = loadFours<3> (vectors, index + 3);
  const Lanes xy_ab = LANES_SHUFFLE (a, b, 0, 1, 4, 5), xy_cd = LANES_SHUFFLE (c, d, 0, 1, 4, 5);
  const Lanes z_ab = LANES_SHUFFLE (a, b, 2, 3, 6, 7), z_cd = LANES_SHUFFLE (c, d, 2, 3, 6, 7);
  return {LANES_SHUFFLE (xy_ab, xy_cd, 0, 2, 4, 6), LANES_SHUFFLE (xy_ab, xy_cd, 1, 3, 5, 7),
          LANES_SHUFFLE (z_ab, z_cd, 0, 2, 4, 6)};
}

/** As above; zeros where there are no vectors. */
LANES_INLINE Lanes3
load3OrZero (const float* vectors, const std::uint32_t* index)
{
  return vectors != nullptr ? load3 (vectors, index) : Lanes3 {};
}

struct Lanes2
{
  Lanes x, y;
};

/** The vectors of two floats that \a index names. Reads eight bytes past each. */
LANES_INLINE Lanes2
load2 (const float* vectors, const std::uint32_t* index)
{
  const Lanes a = loadFours<2> (vectors, index), b = loadFours<2> (vectors, index + 1),
              c = loadFours<2> (vectors, index + 2), d = loadFours<2> (vectors, index + 3);
  const Lanes ab = LANES_SHUFFLE (a, b, 0, 1, 4, 5), cd = LANES_SHUFFLE (c, d, 0, 1, 4, 5);
  return {LANES_SHUFFLE (ab, cd, 0, 2, 4, 6), LANES_SHUFFLE (ab, cd, 1, 3, 5, 7)};
}

/** The numbers that \a index names. */
LANES_INLINE Lanes
load1 (const float* numbers, const std::uint32_t* index)
{
  Lanes value;
  for (int lane = 0; lane < lane_count; ++lane)
    value[lane] = numbers[index[lane]];
  return value;
}

/** As load3, but reads nothing past them: where another thread may be writing. */
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

/** The points p = base + offset of a block's lanes, and the way from them to others. */
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
    const Lanes3 difference = load3 (base_, index) - own_base_;
    return offset_ != nullptr ? difference + (load3 (offset_, index) - own_offset_) : difference;
  }

private:
  const float* base_;
  const float* offset_;
  Lanes3 own_base_;
  Lanes3 own_offset_;
};

/** Ones in the lanes whose neighbour is not the node itself: a row that is shorter than its block's repeats the node. */
LANES_INLINE Mask
isOther (const std::uint32_t* neighbor, const std::uint32_t* own)
{
  return load<Mask> (neighbor) != load<Mask> (own);
}
} // namespace PCL_NORMAL_SMOOTHING_ISA
} // namespace core
} // namespace pcl_normal_smoothing
