// SPDX-License-Identifier: BSD-3-Clause
//
// The loading path of the tools under libFuzzer: any input must be read as a cloud or a mesh, or be refused with a
// FileError or core::Error, and nothing else.
#include "clouds/cloud_graph.h"
#include "files/tool_error.h"
#include "meshes/mesh_io.h"

#include <pcl_normal_smoothing/core/error.h>

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <new>

using namespace pcl_normal_smoothing;

/** Refuses large allocations. In a tool, loadMesh does so by a limit on the process, but under such a limit
  * AddressSanitizer terminates instead of throwing std::bad_alloc. */
void*
operator new (std::size_t size)
{
  constexpr std::size_t bound = std::size_t (128) << 20;
  void* const data = size < bound ? std::malloc (size) : nullptr;
  if (data == nullptr)
    throw std::bad_alloc ();
  return data;
}

void
operator delete (void* data) noexcept
{
  std::free (data);
}

void
operator delete (void* data, std::size_t) noexcept
{
  std::free (data);
}

namespace
{
/** In memory, and one file per process: several fuzzers may run at once. */
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
    std::abort (); // fewer bytes than its header says
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
