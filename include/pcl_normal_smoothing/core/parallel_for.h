// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>

namespace pcl_normal_smoothing
{
/** Called now and then with the share of the work done, 0 to 1, never falling, from the thread that started the
  * work. Return false to cancel. */
using ProgressCallback = std::function<bool (double)>;

namespace core
{
/** How a stage runs: its threads, and the part of the overall progress that it reports. */
class Execution
{
public:
  /** \param[in] threads number of threads, 0: all cores
    * \param[in] progress may be empty */
  explicit Execution (unsigned threads = 0, ProgressCallback progress = {});

  /** The same threads and callback, reporting the range from \a from to \a to, of \a of, within this execution's
    * range. */
  Execution
  part (double from, double to, double of = 1) const;

  /** The same threads, always reporting the start of the range: lets an unknown number of steps be cancelled. */
  Execution
  still () const;

  /** The same threads, reporting nothing: for steps that take hardly any time. */
  Execution
  silent () const;

  /** \throw Cancelled if the callback asks to stop
    * \param[in] done share of this execution's work, 0 to 1 */
  void
  report (double done) const;

  int
  threads () const
  {
    return threads_;
  }

private:
  int threads_;
  ProgressCallback progress_;
  double from_ = 0;
  double to_ = 1;
};

/** Calls \a body (begin, end) for ranges of at most \a chunk elements that cover [0, size), on all threads.
  * The only place that uses OpenMP. An exception of the body ends the loop and is rethrown to the caller.
  * Results do not depend on the number of threads if the body writes only to elements of its own range. */
void
parallelFor (std::size_t size,
             const Execution& execution,
             const std::function<void (std::size_t, std::size_t)>& body,
             std::size_t chunk = 1024);
} // namespace core
} // namespace pcl_normal_smoothing
