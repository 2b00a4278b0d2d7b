// SPDX-License-Identifier: BSD-3-Clause
// Preloaded into a tool (LD_PRELOAD): raises SIGTERM once the call that SIGNAL_AFTER names has made something, the
// worst moment for a tool that has yet to record what to remove.
#include <dlfcn.h>
#include <sys/stat.h>

#include <csignal>
#include <cstdlib>
#include <cstring>

namespace
{
template <typename... Arguments>
int
callAndRaise (const char* name, Arguments... arguments)
{
  const auto call = reinterpret_cast<int (*) (Arguments...)> (dlsym (RTLD_NEXT, name));
  const int result = call (arguments...);
  const char* wanted = std::getenv ("SIGNAL_AFTER");
  if (result >= 0 && wanted && std::strcmp (wanted, name) == 0)
    raise (SIGTERM);
  return result;
}
} // namespace

extern "C" int
mkdir (const char* path, mode_t mode) noexcept
{
  return callAndRaise ("mkdir", path, mode);
}

extern "C" int
mkostemp (char* path, int flags)
{
  return callAndRaise ("mkostemp", path, flags);
}

extern "C" int
mkostemps (char* path, int suffix, int flags)
{
  return callAndRaise ("mkostemps", path, suffix, flags);
}

extern "C" int
rename (const char* from, const char* to) noexcept
{
  return callAndRaise ("rename", from, to);
}
