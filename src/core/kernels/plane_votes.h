// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lane_vectors.h"

#include "../kernels.h"

namespace pcl_normal_smoothing
{
namespace core
{
namespace PCL_NORMAL_SMOOTHING_ISA
{
/** The angles of (x, y) as fractions of a full turn, [0, 1), within 0.001: accurate enough to find a bin, and the
  * same on every machine. */
LANES_INLINE Lanes
turnOf (Lanes x, Lanes y)
{
  constexpr float pi = 3.14159265f;
  const Lanes ax = absolute (x), ay = absolute (y), larger = maximum (ax, ay);
  const Lanes a = larger > 0 ? minimum (ax, ay) / larger : splat (0);
  Lanes turn = (a * (pi / 4) + 0.273f * a * (1 - a)) / (2 * pi);
  turn = ay > ax ? 0.25f - turn : turn;
  turn = x < 0 ? 0.5f - turn : turn;
  return ((y < 0) & (turn > 0)) ? 1 - turn : turn;
}

/** The bins of unit directions with z >= 0. */
LANES_INLINE Mask
binOf (const PlaneVotes& votes, Lanes3 direction)
{
  Mask band = {};
  for (std::uint32_t b = 0; b + 1 < votes.bands; ++b)
    band -= direction.z < votes.band_cosine[b]; // a mask is -1 where it is set
  std::uint32_t bands[lane_count];
  std::memcpy (bands, &band, sizeof bands);
  const Lanes begin = load1 (votes.band_begin, bands), count = load1 (votes.band_begin + 1, bands) - begin;
  const Mask column = __builtin_convertvector(turnOf (direction.x, direction.y) * count, Mask);
  const Mask last = __builtin_convertvector(count, Mask) - 1;
  return __builtin_convertvector(begin, Mask) + (column < last ? column : last);
}

/** The unit normals of the planes through triples of points, rotated and flipped to z >= 0, and their bins. */
LANES_INLINE void
votePlanes (const PlaneVotes& votes, int first)
{
  const Lanes3 a = load3 (votes.points, votes.triples[0] + first);
  const Lanes3 p = load3 (votes.points, votes.triples[1] + first) - a;
  const Lanes3 q = load3 (votes.points, votes.triples[2] + first) - a;
  const Lanes3 cross = {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
  const auto rotated = [&] (int row) LANES_LAMBDA {
    const float* axis = votes.rotation[row];
    return axis[0] * cross.x + axis[1] * cross.y + axis[2] * cross.z;
  };
  const Lanes3 normal = {rotated (0), rotated (1), rotated (2)};
  const Lanes length = squareRoot (dot (normal, normal));
  const Mask plane = length > 0;
  const Lanes3 unit = (plane ? withSignOf (1 / length, normal.z) : splat (0)) * normal;
  store (votes.normals[0] + first, unit.x);
  store (votes.normals[1] + first, unit.y);
  store (votes.normals[2] + first, unit.z);
  const Mask bin = plane ? binOf (votes, unit) : Mask {} - 1;
  std::memcpy (votes.bins + first, &bin, sizeof bin);
}
} // namespace PCL_NORMAL_SMOOTHING_ISA
} // namespace core
} // namespace pcl_normal_smoothing
