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
/** Runs work side by side, each piece in a process of its own: what goes wrong in one, a lack of memory as well, leaves
  * the others alone. Processes that this one leaves behind end themselves. To be used before any thread is made. */
class ProcessPool
{
public:
  /** Called with the exit status of the work's process; 128 + signal where a signal ended it. */
  using Finished = std::function<void (int status)>;

  /** \param[in] at_once most pieces of work that run at a time */
  explicit ProcessPool (std::size_t at_once) : at_once_ (at_once) {}

  /** Begins a piece of work, once there is room for it. Its standard output goes nowhere.
    * \param[in] file named in messages
    * \throw std::runtime_error where no process can be made */
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
