// SPDX-License-Identifier: BSD-3-Clause
#include "../kernels.h"

#include <vector>

namespace pcl_normal_smoothing
{
namespace core
{
namespace baseline
{
extern const Kernels table;
}
#ifdef PCL_NORMAL_SMOOTHING_X86
namespace avx2
{
extern const Kernels table;
}
namespace avx512
{
extern const Kernels table;
}
#endif

namespace
{
std::vector<const Kernels*>
findKernels ()
{
  std::vector<const Kernels*> found;
#ifdef PCL_NORMAL_SMOOTHING_X86
  __builtin_cpu_init ();
  if (__builtin_cpu_supports ("avx512f") && __builtin_cpu_supports ("avx512dq") && __builtin_cpu_supports ("avx512vl"))
    found.push_back (&avx512::table);
  if (__builtin_cpu_supports ("avx2"))
    found.push_back (&avx2::table);
#endif
  found.push_back (&baseline::table);
  return found;
}
} // namespace

const Kernels* const*
allKernels (std::size_t& count)
{
  static const std::vector<const Kernels*> found = findKernels ();
  count = found.size ();
  return found.data ();
}

const Kernels&
kernels ()
{
  std::size_t count;
  return *allKernels (count)[0];
}
} // namespace core
} // namespace pcl_normal_smoothing
