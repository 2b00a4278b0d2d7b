// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/padded_allocator.h>

#if __has_include(<sys/mman.h>)
#include <sys/mman.h>
#endif

#include <cstdint>

namespace pcl_normal_smoothing
{
namespace core
{
#ifdef MADV_HUGEPAGE
namespace
{
constexpr std::size_t large_page = std::size_t (2) << 20;
constexpr std::size_t large_array = large_page / 2;

void*
mapPages (std::size_t bytes)
{
  // mmap only aligns to small pages: map one large page more, and unmap what lies before and after.
  const std::size_t whole = (bytes + large_page - 1) / large_page * large_page;
  void* const taken = mmap (nullptr, whole + large_page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (taken == MAP_FAILED)
    throw std::bad_alloc ();
  char* const begin = static_cast<char*> (taken);
  const std::size_t before = large_page - reinterpret_cast<std::uintptr_t> (begin) % large_page;
  munmap (begin, before);
  if (before < large_page)
    munmap (begin + before + whole, large_page - before);
  // A large page for the rest would waste memory.
  madvise (begin + before, bytes / large_page * large_page, MADV_HUGEPAGE);
  return begin + before;
}
} // namespace

void*
allocateBytes (std::size_t bytes)
{
  return bytes < large_array ? ::operator new (bytes) : mapPages (bytes);
}

void
freeBytes (void* data, std::size_t bytes)
{
  if (bytes < large_array)
    ::operator delete (data);
  else
    munmap (data, (bytes + large_page - 1) / large_page * large_page);
}
#else
void*
allocateBytes (std::size_t bytes)
{
  return ::operator new (bytes);
}

void
freeBytes (void* data, std::size_t)
{
  ::operator delete (data);
}
#endif
} // namespace core
} // namespace pcl_normal_smoothing
