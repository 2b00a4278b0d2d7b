// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/wait.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>

namespace test_support
{
/** A child process that a test started; killed by the destructor if nobody waited for it. */
class ChildProcess
{
public:
  /** \param[in] number as returned by fork to the parent \throw std::runtime_error if it is not the id of a process:
    * kill with -1 would signal every process of the user */
  explicit ChildProcess (pid_t number) : number_ (number)
  {
    if (number <= 0)
      throw std::runtime_error (std::string ("no process was started (") + std::strerror (errno) + ")");
  }

  ChildProcess (ChildProcess&& other) noexcept : number_ (std::exchange (other.number_, 0)) {}

  ChildProcess&
  operator= (ChildProcess&&) = delete;

  ~ChildProcess ()
  {
    send (SIGKILL);
    if (number_ > 0)
      ::waitpid (number_, nullptr, 0);
  }

  pid_t
  number () const
  {
    return number_;
  }

  /** Does nothing if the process was waited for. */
  void
  send (int signal) const
  {
    if (number_ > 0)
      ::kill (number_, signal);
  }

  /** \return its exit status, or 128 + signal if a signal ended it \throw std::runtime_error if called twice */
  int
  wait ()
  {
    const pid_t number = std::exchange (number_, 0);
    int status = 0;
    while (number > 0 && ::waitpid (number, &status, 0) < 0 && errno == EINTR)
      ;
    if (number <= 0)
      throw std::runtime_error ("the process was waited for before");
    return WIFEXITED (status) ? WEXITSTATUS (status) : 128 + WTERMSIG (status);
  }

private:
  pid_t number_;
};
} // namespace test_support
