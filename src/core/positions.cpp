// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/positions.h>

#include <algorithm>
#include <cstring>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
/** \param[in,out] hash of the preceding coordinates */
void
mix (const Eigen::Vector3f& coordinates, std::uint32_t& hash)
{
  for (int d = 0; d < 3; ++d) {
    const float coordinate = coordinates[d] + 0.0f; // -0 is 0
    std::uint32_t bits;
    std::memcpy (&bits, &coordinate, sizeof bits);
    hash = (hash ^ bits) * 0x9E3779B1u;
    hash = (hash ^ (hash >> 15)) * 0x85EBCA77u;
    hash ^= hash >> 13;
  }
}
} // namespace

bool
hasOffsets (const Positions& positions)
{
  constexpr std::size_t chunk = 3 * 1024; // returning at the first hit would prevent vectorisation
  const float* const number = positions.offset.empty () ? nullptr : positions.offset.data ()->data ();
  const std::size_t count = 3 * positions.offset.size ();
  for (std::size_t begin = 0; begin < count; begin += chunk) {
    int found = 0;
    for (std::size_t i = begin; i < std::min (count, begin + chunk); ++i)
      found |= number[i] != 0;
    if (found != 0)
      return true;
  }
  return false;
}

Vectors
startOf (const Positions& positions)
{
  return hasOffsets (positions) ? positions.offset : Vectors ();
}

Vectors
displacements (const Vectors& start, const Positions& positions)
{
  Vectors result = positions.offset;
  for (std::size_t i = 0; i < start.size (); ++i)
    result[i] -= start[i];
  return result;
}

std::uint32_t
hashOf (const Positions& positions, std::size_t i)
{
  std::uint32_t hash = 2166136261u;
  mix (positions.base[i], hash);
  // Far from the origin, many points in double precision share a base.
  if (positions.offset[i] != Eigen::Vector3f (0, 0, 0))
    mix (positions.offset[i], hash);
  return hash;
}
} // namespace core
} // namespace pcl_normal_smoothing
