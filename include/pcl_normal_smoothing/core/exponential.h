// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstring>

namespace pcl_normal_smoothing
{
namespace core
{
/** exp (-x) for x >= 0 within 2e-7 relative; 0 from x = 87 on, NaN for NaN.
  *
  * Plain arithmetic in a fixed order: the same bits with every instruction set, where std::exp differs between machines,
  * and a loop over it vectorises. */
inline float
expOfMinus (float x)
{
  // exp (-x) = 2^n exp (r), n = round (-x / ln 2), |r| <= ln 2 / 2; ln 2 in two parts, the first exact times n.
  constexpr float log2_e = 1.44269504f, ln2_high = 0.693359375f, ln2_low = -2.12194440e-4f;
  constexpr float round_to_integer = 12582912.0f; // 1.5 * 2^23: adding it leaves the integer in the low bits
  const float clamped = x > 87.0f ? 87.0f : x;
  const float shifted = -clamped * log2_e + round_to_integer;
  const float n = shifted - round_to_integer;
  const float r = (-clamped - n * ln2_high) - n * ln2_low;
  float polynomial = 1.0f / 5040;
  polynomial = polynomial * r + 1.0f / 720;
  polynomial = polynomial * r + 1.0f / 120;
  polynomial = polynomial * r + 1.0f / 24;
  polynomial = polynomial * r + 1.0f / 6;
  polynomial = polynomial * r + 0.5f;
  polynomial = polynomial * r + 1.0f;
  polynomial = polynomial * r + 1.0f;
  std::uint32_t bits;
  std::memcpy (&bits, &shifted, sizeof bits);
  bits = (bits + 127u) << 23; // the exponent field of 2^n
  float power;
  std::memcpy (&power, &bits, sizeof power);
  return x >= 87.0f ? 0.0f : polynomial * power;
}

/** The Gaussian of eq. 5, exp (-x^2 / (2 sigma^2)), from x^2 and 1 / (2 sigma^2). */
inline float
gaussian (float x_squared, float inverse_two_sigma_squared)
{
  return expOfMinus (x_squared * inverse_two_sigma_squared);
}
} // namespace core
} // namespace pcl_normal_smoothing
