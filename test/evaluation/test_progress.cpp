// SPDX-License-Identifier: BSD-3-Clause
#include "study/progress.h"

#include <gtest/gtest.h>

#include <thread>

using namespace pcl_normal_smoothing::evaluation;

TEST (Progress, TellsDurations)
{
  EXPECT_EQ (durationText (0.2), "0 s");
  EXPECT_EQ (durationText (59.4), "59 s");
  EXPECT_EQ (durationText (200), "3 min 20 s");
  EXPECT_EQ (durationText (3900), "1 h 5 min");
}

TEST (Progress, GoesByWhatTheLikeHasTaken)
{
  Progress progress;
  EXPECT_EQ (progress.secondsLeft (), 0);
  for (int i = 0; i < 4; ++i)
    progress.plan (Work::SWEEP, 1000);
  EXPECT_GT (progress.secondsLeft (), 0); // a guess, as none is done yet
  std::this_thread::sleep_for (std::chrono::milliseconds (40));
  progress.done (Work::SWEEP, 1000, "one");
  EXPECT_GT (progress.secondsLeft (), 0.1);
  EXPECT_LT (progress.secondsLeft (), 3); // about 3 x 0.04 on an idle machine
  const double before = progress.secondsLeft ();
  progress.skip (Work::SWEEP, 1000);
  EXPECT_NEAR (progress.secondsLeft (), before * 2 / 3, 1e-9);
}
