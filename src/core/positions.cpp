// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/positions.h>

#include <algorithm>

namespace pcl_normal_smoothing
{
namespace core
{
bool
hasOffsets (const Positions& positions)
{
  constexpr std::size_t chunk = 3 * 1024; // an end at once would keep the compiler from looking at many together
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
} // namespace core
} // namespace pcl_normal_smoothing
