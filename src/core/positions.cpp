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
  return !std::all_of (positions.offset.begin (), positions.offset.end (),
                       [] (const auto& v) { return v.x () == 0 && v.y () == 0 && v.z () == 0; });
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
