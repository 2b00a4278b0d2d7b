// SPDX-License-Identifier: BSD-3-Clause
#include "process_pool.h"

#include "tool.h"

#include <sys/wait.h>
#include <unistd.h>

#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
void
endWithParent ([[maybe_unused]] pid_t parent)
{
#ifdef __linux__
  prctl (PR_SET_PDEATHSIG, SIGTERM);
  if (getppid () != parent)
    _exit (128 + SIGTERM);
#endif
}
} // namespace

void
ProcessPool::start (const std::string& file, const std::function<void ()>& work, const Finished& finished)
{
  while (running_.size () >= at_once_)
    waitForOne ();
  std::fflush (nullptr); // otherwise both processes would write what is still buffered
  const pid_t parent = getpid ();
  const pid_t process = fork ();
  if (process < 0)
    throw std::runtime_error (std::string ("no process can be made (") + std::strerror (errno) + ")");
  if (process > 0) {
    running_[process] = finished;
    return;
  }
  endWithParent (parent);
  const bool silent = std::freopen ("/dev/null", "w", stdout) != nullptr;
  _exit (silent ? exitStatusOf (file, work) : EXIT_FAILURE);
}

void
ProcessPool::waitForOne ()
{
  int ending = 0;
  const pid_t process = waitpid (-1, &ending, 0);
  const auto found = running_.find (process);
  if (found == running_.end ()) {
    if (process < 0 && errno != EINTR)
      throw std::runtime_error (std::string ("cannot wait for a process (") + std::strerror (errno) + ")");
    return;
  }
  const Finished finished = found->second;
  running_.erase (found);
  finished (WIFEXITED (ending) ? WEXITSTATUS (ending) : 128 + WTERMSIG (ending));
}

void
ProcessPool::finish ()
{
  while (!running_.empty ())
    waitForOne ();
}
} // namespace tools
} // namespace pcl_normal_smoothing
