// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#if defined(__AVX2__)
#include <immintrin.h>
#endif

// Files that include this are compiled once per instruction set, each time into a different namespace. They use plain
// arithmetic on arrays and nothing from Eigen or the standard library, so that no code for a newer machine leaks into
// functions shared by all.
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

/** One number of several points, one point per lane. Every lane computes what a scalar would, so the result does not
  * depend on the number of lanes. Comparisons give a Mask, and mask ? a : b chooses lane by lane. */
typedef float Lanes __attribute__ ((vector_size (4 * lane_count)));
typedef std::int32_t Mask __attribute__ ((vector_size (4 * lane_count)));
typedef std::uint8_t Bytes __attribute__ ((vector_size (lane_count)));
typedef std::uint16_t Shorts __attribute__ ((vector_size (2 * lane_count)));
constexpr float max_short = 65535;

/** Copied member by member: some compilers copy it as memory in smaller pieces, and the later vector load stalls on
  * them. */
struct Lanes3
{
  Lanes x, y, z;

  Lanes3 () = default;

  LANES_INLINE
  Lanes3 (Lanes of_x, Lanes of_y, Lanes of_z) : x (of_x), y (of_y), z (of_z) {}

  LANES_INLINE
  Lanes3 (const Lanes3& other) : x (other.x), y (other.y), z (other.z) {}

  LANES_INLINE Lanes3&
  operator= (const Lanes3& other)
  {
    x = other.x, y = other.y, z = other.z;
    return *this;
  }
};

struct Lanes2
{
  Lanes x, y;
};

LANES_INLINE Lanes
splat (float value)
{
  return value - Lanes {}; // value + 0 would not be optimised away, because of -0
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

/** Truncates numbers from 0 to max_short to integers. */
LANES_INLINE void
storeShorts (std::uint16_t* to, Lanes value)
{
  const Shorts shorts = __builtin_convertvector(__builtin_convertvector(value, Mask), Shorts);
  std::memcpy (to, &shorts, sizeof shorts);
}

LANES_INLINE Lanes
loadShorts (const std::uint16_t* from)
{
  return __builtin_convertvector(__builtin_convertvector(load<Shorts> (from), Mask), Lanes);
}

/** a < b ? a : b; hence b if either is NaN */
LANES_INLINE Lanes
minimum (Lanes a, Lanes b)
{
#if defined(__AVX512F__)
  // gcc compiles a ?: into two instructions; the unmasked intrinsic would do, but gcc warns inside its own header.
  return (Lanes) _mm512_maskz_min_ps (0xffff, (__m512) a, (__m512) b);
#else
  return a < b ? a : b;
#endif
}

/** a > b ? a : b; hence b if either is NaN */
LANES_INLINE Lanes
maximum (Lanes a, Lanes b)
{
#if defined(__AVX512F__)
  return (Lanes) _mm512_maskz_max_ps (0xffff, (__m512) a, (__m512) b);
#else
  return a > b ? a : b;
#endif
}

LANES_INLINE Lanes
absolute (Lanes a)
{
  return (Lanes) ((Mask) a & 0x7fffffff);
}

/** a where the sign bit of \a sign is clear, -a where it is set. */
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

LANES_INLINE Lanes3
operator/ (Lanes3 a, Lanes s)
{
  return {a.x / s, a.y / s, a.z / s};
}

/** a in the lanes where the mask is set, b in the others. */
LANES_INLINE Lanes3
choose (Mask mask, Lanes3 a, Lanes3 b)
{
  return {mask ? a.x : b.x, mask ? a.y : b.y, mask ? a.z : b.z};
}

LANES_INLINE Lanes
dot (Lanes3 a, Lanes3 b)
{
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

/** exp (-x) for x >= 0 with a relative error within 2e-7 (1 + x / 2); 0 from x = 88 on; NaN for NaN. */
LANES_INLINE Lanes
expOfMinus (Lanes x)
{
  // exp (-x) = 2^n 2^-r, n = round (-x / ln 2), |r| <= 1 / 2.
  constexpr float log2_e = 1.44269504f;
  // Adding 1.5 * 2^23 leaves the rounded integer in the low bits of the sum; the additional 127 makes n an exponent
  // field, which from n = -127 on is that of zero.
  constexpr float round_to_integer = 12582912.0f + 127;
  const Lanes power_of_half = minimum (splat (127.0f), x * log2_e);
  const Lanes shifted = round_to_integer - power_of_half;
  const Lanes r = power_of_half + (shifted - round_to_integer);
  // Begins with 1 - r ln 2; the minimax polynomial of those: relative error 1.05e-7.
  Lanes polynomial = splat (-0.00133002584f);
  constexpr float coefficients[] = {0.00966971833f, -0.0555055998f, 0.240222812f, -0.693147182f, 1.0f};
  for (const float coefficient : coefficients)
    polynomial = polynomial * r + coefficient;
  return polynomial * (Lanes) ((Mask) shifted << 23); // 2^n
}
} // namespace PCL_NORMAL_SMOOTHING_ISA
} // namespace core
} // namespace pcl_normal_smoothing
