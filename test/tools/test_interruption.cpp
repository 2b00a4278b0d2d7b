// SPDX-License-Identifier: BSD-3-Clause
#include "command_line/tool.h"
#include "files/output_file.h"
#include "tool_runner.h"

#include <unistd.h>

#include <csignal>

#include <chrono>
#include <thread>

using namespace pcl_normal_smoothing;

namespace
{
class Interruption : public ToolTest
{
protected:
  /** Interrupts a tool that would run for hours. */
  Ending
  interrupt (int signal)
  {
    RunningTool tool ({TOOLS_FOLDER "/pcl_normal_smoothing", path ("wave.pcd"), path ("out.pcd"), "-update", "paper",
                       "-point_iterations", "1000000"},
                      folder_);
    std::this_thread::sleep_for (std::chrono::milliseconds (700));
    tool.send (signal);
    return tool.wait ();
  }
};

/** A tool that is interrupted while it writes. */
class WritingTool : public tools::Tool
{
public:
  explicit WritingTool (int signal) : signal_ (signal) {}

private:
  void
  describe (tools::Options& options) override
  {
    options.describe ("writes", {"output"});
  }

  void
  work (const tools::Options& options) override
  {
    tools::OutputFile output (options.file (0));
    output.write (std::string (3u << 20, 'x'));
    raise (signal_);
    output.commit ();
  }

  int signal_;
};
} // namespace

TEST_F (Interruption, EndsTheWork)
{
  savePcd (makeWave (), path ("wave.pcd"));
  writeText (path ("out.pcd"), "precious");
  for (const int signal : {SIGINT, SIGTERM}) {
    EXPECT_EQ (interrupt (signal).status, 128 + signal);
    EXPECT_EQ (contentOf (path ("out.pcd")), "precious");
    EXPECT_EQ (files (), (std::set<std::string> {"out.pcd", "wave.pcd"}));
  }
}

TEST_F (Interruption, RemovesWhatIsHalfWritten)
{
  writeText (path ("out.pcd"), "precious");
  for (const int signal : {SIGINT, SIGTERM}) {
    const pid_t number = fork ();
    if (number == 0) {
      std::string name = "writer", output = path ("out.pcd");
      char* words[] = {name.data (), output.data (), nullptr};
      WritingTool tool (signal);
      _exit (tools::runTool (2, words, tool));
    }
    EXPECT_EQ (test_support::ChildProcess (number).wait (), 128 + signal);
    EXPECT_EQ (contentOf (path ("out.pcd")), "precious");
    EXPECT_EQ (files (), (std::set<std::string> {"out.pcd"}));
  }
}

TEST_F (Interruption, AFileThatIsNotCommittedLeavesNothing)
{
  writeText (path ("out.pcd"), "precious");
  {
    tools::OutputFile output (path ("out.pcd"));
    output.write (std::string (3u << 20, 'x'));
    EXPECT_EQ (files ().size (), 2u);
  }
  EXPECT_EQ (contentOf (path ("out.pcd")), "precious");
  EXPECT_EQ (files ().size (), 1u);
  tools::OutputFile output (path ("out.pcd"));
  output.write ("new");
  output.commit ();
  EXPECT_EQ (contentOf (path ("out.pcd")), "new");
  EXPECT_EQ (files ().size (), 1u);
}
