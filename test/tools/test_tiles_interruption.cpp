// SPDX-License-Identifier: BSD-3-Clause
#include "tiles_fixture.h"

#include <chrono>
#include <csignal>
#include <thread>

namespace
{
class TilesInterruption : public Tiles
{};
} // namespace

TEST_F (TilesInterruption, AtAnyTime)
{
  saveCloud (wavyCloud (200000), "large.pcd");
  for (const int signal : {SIGINT, SIGTERM, SIGKILL})
    for (int delay = 20; delay < 400; delay += 60) {
      RunningTool tool ({TOOLS_FOLDER "/pcl_normal_smoothing_tiles", "plan", path ("large.d"), path ("large.pcd"),
                         "-max_points", "3000", "-threads", "1"},
                        folder_);
      std::this_thread::sleep_for (std::chrono::milliseconds (delay));
      tool.send (signal);
      const Ending ending = tool.wait ();
      EXPECT_EQ (ending.status, 128 + signal) << ending.err;
      EXPECT_TRUE (signal == SIGKILL || files ().count ("large.d") == 0) << "signal " << signal << " after " << delay;
      EXPECT_EQ (run ("pcl_normal_smoothing_tiles run large.d").status, 2) << "half a plan was taken for one";
    }
  saveCloud (wavyCloud (900), "cloud.pcd");
  succeed (
      "pcl_normal_smoothing_tiles plan tiles.d cloud.pcd -update paper -point_iterations 1000000 -max_points 2000");
  const std::set<std::string> before = filesIn ("tiles.d");
  RunningTool tool ({TOOLS_FOLDER "/pcl_normal_smoothing_tiles", "run", path ("tiles.d")}, folder_);
  std::this_thread::sleep_for (std::chrono::milliseconds (500));
  tool.send (SIGTERM);
  EXPECT_EQ (tool.wait ().status, 143);
  EXPECT_EQ (filesIn ("tiles.d"), before);
}

TEST_F (TilesInterruption, WhereAFileWasJustMade)
{
  saveCloud (wavyCloud (900), "cloud.pcd");
  for (const char* call : {"mkdir", "mkostemp", "mkostemps", "rename"}) {
    const Ending ending =
        RunningTool ({"/usr/bin/env", "LD_PRELOAD=" SIGNAL_AFTER_CALL, std::string ("SIGNAL_AFTER=") + call,
                      "ASAN_OPTIONS=verify_asan_link_order=0", TOOLS_FOLDER "/pcl_normal_smoothing_tiles", "plan",
                      path ("tiles.d"), path ("cloud.pcd"), "-max_points", "3000"},
                     folder_)
            .wait ();
    EXPECT_EQ (ending.status, 128 + SIGTERM) << call << ending.err;
    EXPECT_EQ (files ().count ("tiles.d"), 0u) << call;
  }
}
