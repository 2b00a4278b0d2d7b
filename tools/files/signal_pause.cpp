// SPDX-License-Identifier: BSD-3-Clause
#include "signal_pause.h"

#include <sched.h>

#include <atomic>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
std::atomic_flag taken = ATOMIC_FLAG_INIT; // a mutex is not safe in a signal handler
} // namespace

SignalPause::SignalPause () noexcept
{
  sigset_t all;
  sigfillset (&all);
  pthread_sigmask (SIG_SETMASK, &all, &before_);
  endAll ();
}

SignalPause::~SignalPause ()
{
  taken.clear (std::memory_order_release);
  pthread_sigmask (SIG_SETMASK, &before_, nullptr);
}

void
SignalPause::endAll () noexcept
{
  while (taken.test_and_set (std::memory_order_acquire))
    sched_yield ();
}
} // namespace tools
} // namespace pcl_normal_smoothing
