// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <string>

namespace pcl_normal_smoothing::evaluation
{

/** Kinds of rows. Rows of one kind take about the same time for the same number of points. */
enum class Work
{
  OWN,
  SWEEP,
  PEER
};

/** Reports on stderr how far a study is, and estimates the remaining time from that of similar rows so far. */
class Progress
{
public:
  Progress ();

  /** Announces a row for a cloud of \a points. */
  void
  plan (Work work, std::size_t points);

  /** A planned row is done; \a what describes it for the user. */
  void
  done (Work work, std::size_t points, const std::string& what);

  /** A planned row needs no work after all. */
  void
  skip (Work work, std::size_t points);

  double
  secondsLeft () const;

  /** Ends the line on a terminal. */
  void
  finish ();

private:
  struct Pace
  {
    double planned = 0, done = 0; // for the points that are done
    double seconds = 0;           // for those that are done
    double guess = 0;             // seconds per point, before any is done
  };

  void
  show (const std::string& what);

  std::array<Pace, 3> paces_;
  std::chrono::steady_clock::time_point last_, shown_;
  bool on_terminal_;
};

/** "1 h 5 min", "5 min 20 s", "20 s". */
std::string
durationText (double seconds);

} // namespace pcl_normal_smoothing::evaluation
