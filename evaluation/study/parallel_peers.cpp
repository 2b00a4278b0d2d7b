// SPDX-License-Identifier: BSD-3-Clause
#include "study/parallel_peers.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <future>
#include <mutex>
#include <thread>

namespace pcl_normal_smoothing::evaluation
{

void
runPeers (const std::vector<PeerSetting>& settings,
          const std::vector<Eigen::Vector3d>& noisy,
          const PeerRun& run,
          const std::function<void (std::size_t, const PeerResult&)>& take)
{
  std::mutex mutex;
  std::condition_variable arrived;
  std::deque<std::pair<std::size_t, PeerResult>> results;
  std::atomic<std::size_t> next {0};
  const auto runSome = [&] {
    for (std::size_t i = next++; i < settings.size (); i = next++) {
      PeerResult result = runPeer (settings[i], noisy, run);
      const std::lock_guard<std::mutex> lock (mutex);
      results.emplace_back (i, std::move (result));
      arrived.notify_one ();
    }
  };
  const std::size_t count =
      std::min<std::size_t> (std::max (std::thread::hardware_concurrency (), 1u), settings.size ());
  struct Workers // if take throws, workers only finish their current run
  {
    std::atomic<std::size_t>& next;
    std::size_t size;
    std::vector<std::future<void>> all;

    ~Workers ()
    {
      next = size;
    }
  } workers {next, settings.size (), {}};
  for (std::size_t i = 0; i < count; ++i)
    workers.all.push_back (std::async (std::launch::async, runSome));
  for (std::size_t taken = 0; taken < settings.size (); ++taken) {
    std::unique_lock<std::mutex> lock (mutex);
    arrived.wait (lock, [&] { return !results.empty (); });
    const auto [i, result] = std::move (results.front ());
    results.pop_front ();
    lock.unlock ();
    take (i, result);
  }
}

} // namespace pcl_normal_smoothing::evaluation
