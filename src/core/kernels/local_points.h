// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lane_vectors.h"
#include "quadric.h"

#include "../kernels.h"
#include "../limits.h"

namespace pcl_normal_smoothing
{
namespace core
{
namespace PCL_NORMAL_SMOOTHING_ISA
{
/** (1 - x / 16)^16, zero from x = 16 on: a substitute for exp (-x) where only a weight is needed. x >= 0 or NaN */
LANES_INLINE Lanes
bell (Lanes x)
{
  Lanes t = maximum (1 - x * 0.0625f, splat (0));
  t *= t;
  t *= t;
  t *= t;
  return t * t;
}

/** \a displacement, shortened to at most \a limit; zero where its length is not finite, as for points so far away
  * that distances overflow. */
LANES_INLINE Lanes3
capped (Lanes3 displacement, float limit)
{
  const Lanes length = squareRoot (dot (displacement, displacement));
  const Lanes scale = length > limit ? limit / length : splat (1);
  const Mask finite = length < __builtin_inff ();
  return {finite ? scale * displacement.x : splat (0), finite ? scale * displacement.y : splat (0),
          finite ? scale * displacement.z : splat (0)};
}

/** The neighbours of the lanes' points, relative to these and in units of the distance of the farthest; the points
  * themselves come first. */
template <std::size_t max_count>
struct LocalPointsOf
{
  Lanes3 at[max_count];
  Lanes one[max_count]; // 1, or 0 beyond the end of a row
  std::size_t count;
  Lanes reach; // distance of the farthest

  LANES_INLINE
  LocalPointsOf (const NodeArrays& nodes, const BlockRows& rows, const std::uint32_t* own)
  : count (rows.length < max_count ? rows.length : max_count)
  {
    const Points points (nodes.base, nodes.offset, own);
    Lanes farthest = {};
    for (std::size_t j = 0; j < count; ++j) {
      at[j] = points.difference (own + block_size * j);
      one[j] = isOther (own + block_size * j, own) | (j == 0 ? -1 : 0) ? splat (1) : splat (0);
      farthest = maximum (farthest, dot (at[j], at[j]));
    }
    reach = squareRoot (farthest);
    const Lanes scale = farthest > 0 ? 1 / reach : splat (0);
    for (std::size_t j = 0; j < count; ++j)
      at[j] = scale * at[j];
  }

  LANES_INLINE Lanes
  size () const
  {
    Lanes sum = {};
    for (std::size_t j = 0; j < count; ++j)
      sum += one[j];
    return sum;
  }
};

using LocalPoints = LocalPointsOf<max_row_length>;

/** The normal of the weighted least-squares plane through the points. */
template <std::size_t max_count>
LANES_INLINE Lanes3
planeNormal (const LocalPointsOf<max_count>& local, const Lanes* weights)
{
  Lanes sum = {}, x = {}, y = {}, z = {}, xx = {}, xy = {}, xz = {}, yy = {}, yz = {}, zz = {};
  for (std::size_t j = 0; j < local.count; ++j) {
    const Lanes3 p = local.at[j];
    const Lanes wx = weights[j] * p.x, wy = weights[j] * p.y, wz = weights[j] * p.z;
    sum += weights[j];
    x += wx, y += wy, z += wz;
    xx += wx * p.x, xy += wx * p.y, xz += wx * p.z, yy += wy * p.y, yz += wy * p.z, zz += wz * p.z;
  }
  const Lanes scale = 1 / maximum (sum, splat (1e-30f));
  x *= scale, y *= scale, z *= scale;
  return smallestEigenvector (xx * scale - x * x, xy * scale - x * y, xz * scale - x * z, yy * scale - y * y,
                              yz * scale - y * z, zz * scale - z * z);
}

/** The normal by eq. 1: weights 1 / distance, the point itself left out. */
LANES_INLINE Lanes3
weightedPlaneNormal (const LocalPoints& local)
{
  Lanes weights[max_row_length];
  for (std::size_t j = 0; j < local.count; ++j) {
    const Lanes sq_dist = dot (local.at[j], local.at[j]);
    weights[j] = sq_dist > 0 ? local.one[j] / squareRoot (maximum (sq_dist, splat (1e-12f))) : splat (0);
  }
  return planeNormal (local, weights);
}

/** The initial normals of the rounds; NaN where a row has fewer than 3 points or they are all equal. In a row of 3
  * the two neighbours always lie on a line, so that rounding decides the normal. */
LANES_INLINE void
startNormals (const StartNormals& normals, const BlockRows& rows, int first)
{
  const std::uint32_t* own = rows.neighbors + first;
  const LocalPoints local (normals.nodes, rows, own);
  const Lanes3 normal = weightedPlaneNormal (local);
  const Mask valid = (local.size () >= 3) & (local.reach > 0) & (dot (normal, normal) > 0.5f);
  const Lanes nan = splat (__builtin_nanf (""));
  store3 (normals.normals, own, choose (valid, normal, {nan, nan, nan}));
}
} // namespace PCL_NORMAL_SMOOTHING_ISA
} // namespace core
} // namespace pcl_normal_smoothing
