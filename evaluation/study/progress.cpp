// SPDX-License-Identifier: BSD-3-Clause
#include "study/progress.h"

#include "command_line/tool.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace pcl_normal_smoothing::evaluation
{
namespace
{
using Clock = std::chrono::steady_clock;

double
secondsBetween (Clock::time_point from, Clock::time_point to)
{
  return std::chrono::duration<double> (to - from).count ();
}
} // namespace

std::string
durationText (double seconds)
{
  const auto whole = std::lround (seconds);
  if (whole >= 3600)
    return std::to_string (whole / 3600) + " h " + std::to_string (whole % 3600 / 60) + " min";
  if (whole >= 60)
    return std::to_string (whole / 60) + " min " + std::to_string (whole % 60) + " s";
  return std::to_string (whole) + " s";
}

Progress::Progress () : last_ (Clock::now ()), shown_ (last_), on_terminal_ (isatty (STDERR_FILENO))
{
  // Measured on two cores of 2020.
  const double guesses[] = {2e-5, 1e-5, 2e-4};
  for (std::size_t i = 0; i < paces_.size (); ++i)
    paces_[i].guess = guesses[i];
}

void
Progress::plan (Work work, std::size_t points)
{
  paces_[static_cast<std::size_t> (work)].planned += static_cast<double> (points);
}

void
Progress::skip (Work work, std::size_t points)
{
  paces_[static_cast<std::size_t> (work)].planned -= static_cast<double> (points);
}

void
Progress::done (Work work, std::size_t points, const std::string& what)
{
  Pace& pace = paces_[static_cast<std::size_t> (work)];
  const auto now = Clock::now ();
  pace.done += static_cast<double> (points);
  pace.seconds += secondsBetween (last_, now);
  last_ = now;
  if (secondsBetween (shown_, now) >= (on_terminal_ ? 0.3 : 10)) {
    show (what);
    shown_ = now;
  }
}

double
Progress::secondsLeft () const
{
  double left = 0;
  for (const Pace& pace : paces_)
    left += (pace.planned - pace.done) * (pace.done > 0 ? pace.seconds / pace.done : pace.guess);
  return left;
}

void
Progress::show (const std::string& what)
{
  const std::string text = durationText (secondsLeft ()) + " left, " + what;
  if (on_terminal_)
    std::fprintf (stderr, "\r\x1b[K%s", text.c_str ());
  else
    tools::note (text);
}

void
Progress::finish ()
{
  if (on_terminal_)
    std::fprintf (stderr, "\r\x1b[K");
}

} // namespace pcl_normal_smoothing::evaluation
