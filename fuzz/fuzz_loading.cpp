// SPDX-License-Identifier: BSD-3-Clause
//
// The loading path of the tools under libFuzzer: any bytes are a cloud or a mesh, or a FileError or core::Error, and never
// anything else.
#include "cloud_graph.h"
#include "mesh_io.h"
#include "tool_error.h"

#include <pcl_normal_smoothing/core/error.h>

#include <malloc.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <new>

using namespace pcl_normal_smoothing;

namespace
{
/** The memory that loading may take, as loadMesh bounds it in a tool: by a limit of the process, under which AddressSanitizer
  * does not throw std::bad_alloc but ends. */
constexpr std::ptrdiff_t memory_bound = std::ptrdiff_t (128) << 20;
std::atomic<std::ptrdiff_t> memory_taken {0}; // below 0 by what other libraries have taken and this gives back
} // namespace

void*
operator new (std::size_t size)
{
  const bool is_much = size >= static_cast<std::size_t> (memory_bound) || memory_taken >= memory_bound;
  void* const data = is_much ? nullptr : std::malloc (size);
  if (data == nullptr)
    throw std::bad_alloc ();
  memory_taken += static_cast<std::ptrdiff_t> (malloc_usable_size (data));
  return data;
}

void
operator delete (void* data) noexcept
{
  memory_taken -= static_cast<std::ptrdiff_t> (malloc_usable_size (data));
  std::free (data);
}

void
operator delete (void* data, std::size_t) noexcept
{
  operator delete (data);
}

namespace
{
/** In memory, and one a process: the fuzzer may run several. */
const std::string&
path ()
{
  static const std::string name = "/dev/shm/fuzz_loading." + std::to_string (getpid ()) + FUZZED_EXTENSION;
  static const int at_exit = std::atexit ([] { std::remove (name.c_str ()); });
  static_cast<void> (at_exit);
  return name;
}

void
load ()
{
#ifdef FUZZED_mesh
  tools::loadMesh (path ());
#else
  const tools::CloudFile file = tools::loadCloud (path ());
  if (file.cloud->data.size () < std::size_t (file.cloud->height) * file.cloud->row_step)
    std::abort (); // fewer bytes than it says
  core::finiteElements (readPositions (tools::positionsOf (file)));
#endif
}
} // namespace

extern "C" int
LLVMFuzzerTestOneInput (const std::uint8_t* data, std::size_t size)
{
  std::ofstream (path (), std::ios::binary)
      .write (reinterpret_cast<const char*> (data), static_cast<std::streamsize> (size));
  try {
    load ();
  }
  catch (const tools::FileError&) {
  }
  catch (const core::Error&) {
  }
  return 0;
}
