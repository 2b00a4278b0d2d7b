// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lanes.h"

namespace pcl_normal_smoothing
{
namespace core
{
namespace PCL_NORMAL_SMOOTHING_ISA
{
LANES_INLINE Lanes3
normalized (Lanes3 a)
{
  return (1 / squareRoot (maximum (dot (a, a), splat (1e-30f)))) * a;
}

/** The axes that complete a normal to a right-handed frame (Duff et al., "Building an Orthonormal Basis, Revisited",
  * 2017). */
struct Frame
{
  Lanes3 normal, u, v;

  LANES_INLINE explicit Frame (Lanes3 n) : normal (n)
  {
    const Lanes sign = withSignOf (splat (1), n.z);
    const Lanes a = -1 / (sign + n.z), b = n.x * n.y * a;
    u = {1 + sign * n.x * n.x * a, sign * b, -sign * n.x};
    v = {b, sign + n.y * n.y * a, -n.y};
  }
};

/** The quadric height = a0 + a1 u + a2 v + a3 u^2 + a4 u v + a5 v^2, fitted by weighted least squares. */
class Quadric
{
public:
  LANES_INLINE void
  add (Lanes u, Lanes v, Lanes height, Lanes weight)
  {
    const Lanes wu = weight * u, wv = weight * v, wuu = wu * u, wuv = wu * v, wvv = wv * v, wh = weight * height;
    const Lanes wuuu = wuu * u, wuuv = wuu * v, wuvv = wvv * u, wvvv = wvv * v;
    const Lanes terms[] = {weight, wu,   wv,       wuu,      wuv,      wvv,      wuuu,    wuuv,
                           wuvv,   wvvv, wuuu * u, wuuu * v, wuuv * v, wvvv * u, wvvv * v};
    for (int i = 0; i < 15; ++i)
      moments_[i] += terms[i];
    const Lanes heights[] = {wh, wh * u, wh * v, wh * u * u, wh * u * v, wh * v * v};
    for (int i = 0; i < 6; ++i)
      height_moments_[i] += heights[i];
  }

  /** Solves the normal equations by Cholesky decomposition.
    * \param[in] ridge added to the second-order terms, as a fraction of the sum of the weights */
  LANES_INLINE void
  solve (Lanes ridge)
  {
    // Index of the moment u^a v^b in each element of the normal equations.
    constexpr int moment[6][6] = {{0, 1, 2, 3, 4, 5},    {1, 3, 4, 6, 7, 8},    {2, 4, 5, 7, 8, 9},
                                  {3, 6, 7, 10, 11, 12}, {4, 7, 8, 11, 12, 13}, {5, 8, 9, 12, 13, 14}};
    Lanes lower[6][6], inverse_diagonal[6], solution[6];
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j <= i; ++j) {
        Lanes sum = moments_[moment[i][j]];
        // Half for u v: a3^2 + a4^2 / 2 + a5^2 is invariant when the frame turns about its normal.
        if (i == j)
          sum += moments_[0] * (i >= 3 ? (i == 4 ? .5f : 1.0f) * ridge + smallest_ridge : splat (smallest_ridge));
        for (int t = 0; t < j; ++t)
          sum -= lower[i][t] * lower[j][t];
        if (i == j)
          inverse_diagonal[i] = 1 / squareRoot (maximum (sum, moments_[0] * smallest_ridge + 1e-30f));
        else
          lower[i][j] = sum * inverse_diagonal[j];
      }
      Lanes sum = height_moments_[i];
      for (int t = 0; t < i; ++t)
        sum -= lower[i][t] * solution[t];
      solution[i] = sum * inverse_diagonal[i];
    }
    for (int i = 5; i >= 0; --i) {
      Lanes sum = solution[i];
      for (int t = i + 1; t < 6; ++t)
        sum -= lower[t][i] * coefficients_[t];
      coefficients_[i] = sum * inverse_diagonal[i];
    }
  }

  LANES_INLINE Lanes
  height (Lanes u, Lanes v) const
  {
    const Lanes* const a = coefficients_;
    return a[0] + a[1] * u + a[2] * v + (a[3] * u + a[4] * v) * u + a[5] * v * v;
  }

  /** 1 + |gradient|^2 at the origin, that is 1 / cos^2 of the slope: a squared height over the frame's plane, divided by
    * it, is the squared distance from the quadric. */
  LANES_INLINE Lanes
  squaredSecant () const
  {
    return 1 + coefficients_[1] * coefficients_[1] + coefficients_[2] * coefficients_[2];
  }

  /** The normal at the origin. */
  LANES_INLINE Lanes3
  normal (const Frame& frame) const
  {
    return normalized ((frame.normal - coefficients_[1] * frame.u) - coefficients_[2] * frame.v);
  }

private:
  static constexpr float smallest_ridge = 1e-7f; // needed in float arithmetic

  Lanes moments_[15] = {}; // 1 u v uu uv vv uuu uuv uvv vvv uuuu uuuv uuvv uvvv vvvv
  Lanes height_moments_[6] = {};
  Lanes coefficients_[6] = {};
};

/** The eigenvector of the smallest eigenvalue of a symmetric positive semidefinite matrix
  * xx xy xz / xy yy yz / xz yz zz: in the adjugate it belongs to the largest eigenvalue, and repeated squaring
  * suppresses the others. */
LANES_INLINE Lanes3
smallestEigenvector (Lanes xx, Lanes xy, Lanes xz, Lanes yy, Lanes yz, Lanes zz)
{
  Lanes a = yy * zz - yz * yz, b = xz * yz - xy * zz, c = xy * yz - xz * yy;
  Lanes d = xx * zz - xz * xz, e = xy * xz - xx * yz, f = xx * yy - xy * xy;
  for (int squaring = 0; squaring < 5; ++squaring) {
    const Lanes scale = 1 / maximum (a + d + f, splat (1e-37f));
    a *= scale, b *= scale, c *= scale, d *= scale, e *= scale, f *= scale;
    const Lanes aa = a * a + b * b + c * c, ab = a * b + b * d + c * e, ac = a * c + b * e + c * f;
    const Lanes dd = b * b + d * d + e * e, de = b * c + d * e + e * f, ff = c * c + e * e + f * f;
    a = aa, b = ab, c = ac, d = dd, e = de, f = ff;
  }
  // The column with the largest diagonal element.
  const Mask first = (a >= d) & (a >= f), second = d >= f;
  return normalized ({first ? a : second ? b : c, first ? b : second ? d : e, first ? c : second ? e : f});
}
} // namespace PCL_NORMAL_SMOOTHING_ISA
} // namespace core
} // namespace pcl_normal_smoothing
