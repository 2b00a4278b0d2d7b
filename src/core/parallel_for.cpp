// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/error.h>
#include <pcl_normal_smoothing/core/parallel_for.h>

#include <omp.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <utility>

namespace pcl_normal_smoothing
{
namespace core
{
Execution::Execution (unsigned threads, ProgressCallback progress)
: threads_ (threads == 0 ? omp_get_num_procs () : static_cast<int> (std::min (threads, 1024u)))
, progress_ (std::move (progress))
{}

Execution
Execution::part (double from, double to, double of) const
{
  Execution result = *this;
  result.from_ = from_ + from / of * (to_ - from_);
  result.to_ = from_ + to / of * (to_ - from_);
  return result;
}

Execution
Execution::still () const
{
  return part (0, 0);
}

Execution
Execution::silent () const
{
  Execution result = *this;
  result.progress_ = nullptr;
  return result;
}

void
Execution::report (double done) const
{
  if (progress_ && !progress_ (from_ + done * (to_ - from_)))
    throw Cancelled ();
}

void
parallelFor (std::size_t size,
             const Execution& execution,
             const std::function<void (std::size_t, std::size_t)>& body,
             std::size_t chunk)
{
  const auto chunks = static_cast<std::ptrdiff_t> ((size + chunk - 1) / chunk);
  std::atomic<std::ptrdiff_t> chunks_done {0};
  std::ptrdiff_t chunks_reported = 0;
  std::atomic<bool> stop {false};
  std::exception_ptr failure;
  // More threads than chunks would only wait.
  const int threads =
      static_cast<int> (std::max<std::ptrdiff_t> (1, std::min<std::ptrdiff_t> (execution.threads (), chunks)));

#pragma omp parallel for schedule(dynamic) num_threads(threads)
  for (std::ptrdiff_t c = 0; c < chunks; ++c) {
    if (stop)
      continue;
    try {
      const std::size_t begin = static_cast<std::size_t> (c) * chunk;
      body (begin, std::min (begin + chunk, size));
      const auto done = ++chunks_done;
      if (omp_get_thread_num () == 0) {
        chunks_reported = done;
        execution.report (static_cast<double> (done) / static_cast<double> (chunks));
      }
    }
    catch (...) {
#pragma omp critical(pcl_normal_smoothing_failure)
      if (!stop.exchange (true))
        failure = std::current_exception ();
    }
  }
  if (failure)
    std::rethrow_exception (failure);
  if (chunks_reported < chunks) // the last chunk was another thread's
    execution.report (1);
}
} // namespace core
} // namespace pcl_normal_smoothing
