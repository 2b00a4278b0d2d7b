// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <functional>
#include <map>
#include <string>

namespace pcl_normal_smoothing
{
namespace tools
{
/** Runs pieces of work in parallel, each in a process of its own: a failure of one, even for lack of memory, does not
  * affect the others. If this process ends, so do they (on Linux). To be used before any thread is started. */
class ProcessPool
{
public:
  /** Called with the exit status of the work's process; 128 + signal if a signal ended it. */
  using Finished = std::function<void (int status)>;

  /** \param[in] at_once limit on the pieces of work that run at a time */
  explicit ProcessPool (std::size_t at_once) : at_once_ (at_once) {}

  /** Starts a piece of work, as soon as fewer than at_once are running. Its standard output is discarded.
    * \param[in] file named in messages
    * \throw std::runtime_error if no process can be made */
  void
  start (const std::string& file, const std::function<void ()>& work, const Finished& finished);

  /** Waits for all work. */
  void
  finish ();

private:
  void
  waitForOne ();

  std::size_t at_once_;
  std::map<pid_t, Finished> running_;
};
} // namespace tools
} // namespace pcl_normal_smoothing
