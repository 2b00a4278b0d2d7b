// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/positions.h>

#if __has_include(<sys/mman.h>)
#include <sys/mman.h>
#endif

#include <algorithm>
#include <memory>
#include <new>

namespace pcl_normal_smoothing
{
namespace core
{
void*
allocateBytes (std::size_t bytes)
{
  void* const data = ::operator new (bytes);
#ifdef MADV_HUGEPAGE
  constexpr std::size_t large_page = std::size_t (2) << 20;
  void* first = data;
  std::size_t space = bytes; // from the first page that is the array's alone
  if (bytes >= 2 * large_page && std::align (large_page, large_page, first, space) != nullptr)
    madvise (first, space / large_page * large_page, MADV_HUGEPAGE);
#endif
  return data;
}

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
