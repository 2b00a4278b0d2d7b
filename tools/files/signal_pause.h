// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <csignal>

namespace pcl_normal_smoothing
{
namespace tools
{
/** Defers signals while it exists, so that a file and the record of its name come and go together. Not to be nested.
  *
  * A signal that arrives meanwhile ends the tool only afterwards, even if another thread receives it. */
class SignalPause
{
public:
  SignalPause () noexcept;

  ~SignalPause ();

  SignalPause (const SignalPause&) = delete;
  SignalPause&
  operator= (const SignalPause&) = delete;

  /** Waits for a pause to end, and prevents further ones: the tool is about to end. Safe in a signal handler. */
  static void
  endAll () noexcept;

private:
  sigset_t before_;
};
} // namespace tools
} // namespace pcl_normal_smoothing
