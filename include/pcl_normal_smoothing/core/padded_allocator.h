// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace pcl_normal_smoothing
{
namespace core
{
/** Memory for an array, aligned like that of operator new. From a megabyte on it is mapped by mmap, on huge pages where
  * the system has them: fewer page faults and misses of the TLB, and what is freed goes back to the system at once.
  * \throw std::bad_alloc if there is none */
void*
allocateBytes (std::size_t bytes);

/** \param[in] bytes as given to allocateBytes */
void
freeBytes (void* data, std::size_t bytes);

/** Allocates a few bytes more, as kernels read vectors of two or three floats four at a time. vector (n) is not
  * zeroed. */
template <typename T>
struct PaddedAllocator
{
  using value_type = T;

  PaddedAllocator () = default;

  template <typename U>
  PaddedAllocator (const PaddedAllocator<U>&)
  {}

  T*
  allocate (std::size_t size)
  {
    static_assert (alignof (T) <= __STDCPP_DEFAULT_NEW_ALIGNMENT__, "allocateBytes aligns no further");
    return static_cast<T*> (allocateBytes (bytes (size)));
  }

  /** Leaves numbers uninitialised if no value is given: pages then belong to the threads that first write to them. */
  template <typename U>
  void
  construct (U* place)
  {
    ::new (static_cast<void*> (place)) U;
  }

  template <typename U, typename... Values>
  void
  construct (U* place, Values&&... values)
  {
    ::new (static_cast<void*> (place)) U (std::forward<Values> (values)...);
  }

  void
  deallocate (T* data, std::size_t size)
  {
    freeBytes (data, bytes (size));
  }

  friend bool
  operator== (const PaddedAllocator&, const PaddedAllocator&)
  {
    return true;
  }

  friend bool
  operator!= (const PaddedAllocator&, const PaddedAllocator&)
  {
    return false;
  }

private:
  static std::size_t
  bytes (std::size_t size)
  {
    return size * sizeof (T) + 2 * sizeof (float);
  }
};

template <typename T>
using PaddedVector = std::vector<T, PaddedAllocator<T>>;
} // namespace core
} // namespace pcl_normal_smoothing
