// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/error.h>
#include <pcl_normal_smoothing/core/parallel_for.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

namespace
{
using namespace pcl_normal_smoothing::core;

TEST (ParallelFor, CallsTheBodyOnceForEveryElement)
{
  for (const unsigned threads : {0u, 1u, 2u, 4u, 7u, 5000u})
    for (const std::size_t size : {0u, 1u, 63u, 64u, 65u, 6400u, 6401u}) {
      std::vector<std::atomic<int>> calls (size);
      parallelFor (
          size, Execution (threads),
          [&] (std::size_t begin, std::size_t end) {
            EXPECT_LE (end - begin, 64u);
            for (std::size_t i = begin; i < end; ++i)
              ++calls[i];
          },
          64);
      for (std::size_t i = 0; i < size; ++i)
        ASSERT_EQ (calls[i], 1) << "element " << i << " of " << size << ", threads " << threads;
    }
}

TEST (ParallelFor, UsesAllCoresForZero)
{
  EXPECT_EQ (Execution (0).threads (), static_cast<int> (std::thread::hardware_concurrency ()));
  EXPECT_EQ (Execution (3).threads (), 3);
}

TEST (ParallelFor, HandsAnExceptionToTheCaller)
{
  for (const unsigned threads : {1u, 2u, 4u}) {
    std::atomic<int> ranges {0};
    const auto body = [&] (std::size_t begin, std::size_t) {
      ++ranges;
      if (begin >= 500)
        throw std::out_of_range ("element 500");
    };
    try {
      parallelFor (100000, Execution (threads), body, 10);
      FAIL () << "nothing was thrown";
    }
    catch (const std::out_of_range& error) {
      EXPECT_STREQ (error.what (), "element 500");
    }
    EXPECT_LT (ranges, 10000) << "the loop went on after the exception";
  }
}

TEST (ParallelFor, ReportsProgressThatNeverFallsAndEndsAtOne)
{
  for (const unsigned threads : {1u, 2u, 4u}) {
    const auto caller = std::this_thread::get_id ();
    std::vector<double> shares;
    const auto progress = [&] (double share) {
      EXPECT_EQ (std::this_thread::get_id (), caller);
      shares.push_back (share);
      return true;
    };
    parallelFor (
        10000, Execution (threads, progress), [] (std::size_t, std::size_t) {}, 10);
    ASSERT_FALSE (shares.empty ());
    EXPECT_TRUE (std::is_sorted (shares.begin (), shares.end ()));
    EXPECT_GT (shares.front (), 0);
    EXPECT_DOUBLE_EQ (shares.back (), 1) << "threads " << threads;
  }
}

TEST (ParallelFor, PartsOfAnExecutionReportTheirShareOfIt)
{
  std::vector<double> shares;
  const Execution whole (1, [&] (double share) {
    shares.push_back (share);
    return true;
  });
  const auto nothing = [] (std::size_t, std::size_t) {};
  parallelFor (4, whole.part (0.5, 1).part (0, 0.5), nothing, 1);
  const std::vector<double> expected {0.5625, 0.625, 0.6875, 0.75};
  EXPECT_EQ (shares, expected);
}

TEST (ParallelFor, StopsWhereTheCallbackSaysSo)
{
  for (const unsigned threads : {1u, 2u, 4u}) {
    std::atomic<int> ranges {0};
    const Execution execution (threads, [] (double share) { return share < 0.1; });
    const auto body = [&] (std::size_t, std::size_t) {
      ++ranges;
      std::this_thread::sleep_for (std::chrono::microseconds (10)); // or all may be done before the caller's turn
    };
    EXPECT_THROW (parallelFor (100000, execution, body, 10), Cancelled);
    EXPECT_LT (ranges, 10000) << "the loop went on to the end";
    EXPECT_TRUE (threads > 1 || ranges == 1000) << ranges;
  }
}

TEST (ParallelFor, AnExceptionOfTheCallbackReachesTheCaller)
{
  const Execution execution (2, [] (double) -> bool { throw std::runtime_error ("the window is gone"); });
  EXPECT_THROW (parallelFor (
                    1000, execution, [] (std::size_t, std::size_t) {}, 10),
                std::runtime_error);
}
} // namespace
