// SPDX-License-Identifier: BSD-3-Clause
#include "child_process.h"
#include "peer_fixture.h"

#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <thread>

// Misbehaviour of peers, simulated by shell scripts.

namespace pcl_normal_smoothing::evaluation
{
namespace
{
const Points points {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}};
const PeerSetting setting {"LOP", "", false, {{"h", 1}}};

class PeerTrouble : public PeerTest
{
protected:
  std::string
  failure ()
  {
    const PeerResult result = runPeer (setting, points, run);
    EXPECT_EQ (result.points.empty (), !result.failure.empty ());
    return result.failure;
  }

  std::string
  failureOf (const std::string& script)
  {
    useWorker (script);
    return failure ();
  }
};

/** Whether the process is gone, or is a zombie that its parent has yet to collect. */
bool
hasEnded (pid_t process)
{
  for (int i = 0; i < 100; ++i) {
    std::ifstream status ("/proc/" + std::to_string (process) + "/stat");
    std::string number, name, state;
    if (!(status >> number >> name >> state) || state == "Z")
      return true;
    std::this_thread::sleep_for (std::chrono::milliseconds (10));
  }
  return false;
}

TEST_F (PeerTrouble, NoneWhereItCopies)
{
  useWorker ("test \"$1\" = LOP && test \"$4\" = h=1 && cp \"$2\" \"$3\"");
  const PeerResult result = runPeer (setting, points, run);
  EXPECT_EQ ("", result.failure);
  ASSERT_EQ (points.size (), result.points.size ());
  for (std::size_t i = 0; i < points.size (); ++i)
    EXPECT_LT ((result.points[i] - points[i]).norm (), 1e-14);
  EXPECT_GT (result.seconds, 0);
}

TEST_F (PeerTrouble, Crash)
{
  EXPECT_EQ ("crashed (Segmentation fault): last words", failureOf ("echo first; echo last words >&2; kill -SEGV $$"));
}

TEST_F (PeerTrouble, CrashBehindAnotherProgram)
{
  EXPECT_EQ ("crashed (Aborted): assertion failed",
             failureOf ("echo assertion failed; sh -c 'kill -ABRT $$'; exit $?"));
}

TEST_F (PeerTrouble, NonZeroStatus)
{
  EXPECT_EQ ("ended with status 3: no memory", failureOf ("cp \"$2\" \"$3\"; echo no memory; exit 3"));
  EXPECT_EQ ("ended with status 1", failureOf ("exit 1"));
}

TEST_F (PeerTrouble, HangIsEndedWithAllThatItStarted)
{
  run.time_limit = 0.3;
  const auto start = std::chrono::steady_clock::now ();
  EXPECT_EQ ("timed out after 0.3 s", failureOf ("echo working; sleep 100 & echo $! >" + file ("child") + "; wait"));
  EXPECT_LT (std::chrono::steady_clock::now () - start, std::chrono::seconds (5));
  pid_t child = 0;
  std::ifstream (file ("child")) >> child;
  ASSERT_GT (child, 0);
  EXPECT_TRUE (hasEnded (child));
}

TEST_F (PeerTrouble, HangThatIgnoresTheSignal)
{
  run.time_limit = 0.3;
  EXPECT_EQ ("timed out after 0.3 s", failureOf ("trap '' TERM; while :; do sleep 1; done"));
}

TEST_F (PeerTrouble, WhatARunLeavesRunningIsEnded)
{
  EXPECT_EQ ("", failureOf ("sleep 100 & echo $! >" + file ("child") + "; cp \"$2\" \"$3\""));
  pid_t child = 0;
  std::ifstream (file ("child")) >> child;
  ASSERT_GT (child, 0);
  EXPECT_TRUE (hasEnded (child));
}

TEST_F (PeerTrouble, EndsWithTheStudyThatStartedIt)
{
  useWorker ("sleep 100 & echo $! >" + file ("child") + "; wait");
  const pid_t number = ::fork ();
  if (number == 0) {
    runPeer (setting, points, run);
    std::_Exit (0);
  }
  test_support::ChildProcess study (number);
  pid_t child = 0;
  for (int i = 0; i < 500 && child == 0; ++i) {
    std::this_thread::sleep_for (std::chrono::milliseconds (10));
    std::ifstream (file ("child")) >> child;
  }
  ASSERT_GT (child, 0);
  study.send (SIGKILL);
  study.wait ();
  EXPECT_TRUE (hasEnded (child));
  std::filesystem::remove_all (run.work_folder); // the killed study could not clean up
}

TEST_F (PeerTrouble, Output)
{
  EXPECT_EQ ("smooth.points cannot be read: No such file or directory", failureOf ("exit 0"));
  EXPECT_EQ ("smooth.points has 8 bytes, which are no whole points", failureOf ("echo garbage >\"$3\""));
  EXPECT_EQ ("gave 2 points for 3", failureOf ("head -c 48 \"$2\" >\"$3\""));
  EXPECT_EQ ("gave 0 points for 3", failureOf (": >\"$3\""));
  // Eight bytes of 0xff are a NaN.
  EXPECT_EQ ("gave a point that is not finite, number 2",
             failureOf ("{ head -c 64 \"$2\"; printf '\\377\\377\\377\\377\\377\\377\\377\\377'; } >\"$3\""));
}

TEST_F (PeerTrouble, ProgramThatIsNotThere)
{
  run.worker = file ("nothing");
  EXPECT_EQ (run.worker + " is not there: build the target pcl_smoothing_peer", failure ());
  run.meshlabserver = "no_such_meshlabserver";
  EXPECT_EQ ("no_such_meshlabserver is not installed: run evaluation/install_peers.sh",
             whyAbsent ("APSS", run).value ());
  EXPECT_EQ (std::nullopt, whyAbsent ("WLOP"));
}

TEST_F (PeerTrouble, NoSuchPeer)
{
  EXPECT_EQ ("ended with status 1: there is no method named XYZ",
             runPeer ({"XYZ", "", false, {}}, points, run).failure);
}

TEST_F (PeerTrouble, Input)
{
  EXPECT_EQ ("the input has no two different points", runPeer (setting, {}, run).failure);
  EXPECT_EQ ("the input has no two different points", runPeer (setting, {{1, 2, 3}, {1, 2, 3}}, run).failure);
  const double nan = std::numeric_limits<double>::quiet_NaN ();
  EXPECT_EQ ("input point 1 is not finite", runPeer (setting, {{1, 2, 3}, {1, nan, 3}}, run).failure);
}

TEST_F (PeerTrouble, NoWorkFolder)
{
  run.work_folder = file ("missing");
  EXPECT_EQ ("no folder can be made in " + run.work_folder + " (No such file or directory)", failure ());
}

} // namespace
} // namespace pcl_normal_smoothing::evaluation
