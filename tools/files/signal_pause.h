// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <csignal>

namespace pcl_normal_smoothing
{
namespace tools
{
/** Holds signals back, so that a file and the note of its name come and go together. Not to be nested.
  *
  * A signal that comes meanwhile ends the tool after it, also where another thread takes the signal. */
class SignalPause
{
public:
  SignalPause () noexcept;

  ~SignalPause ();

  SignalPause (const SignalPause&) = delete;
  SignalPause&
  operator= (const SignalPause&) = delete;

  /** Waits for a pause to end, and lets none begin any more: the tool is about to end. Safe in a signal handler. */
  static void
  endAll () noexcept;

private:
  sigset_t before_;
};
} // namespace tools
} // namespace pcl_normal_smoothing
