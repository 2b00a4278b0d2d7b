// SPDX-License-Identifier: BSD-3-Clause
#include "tool_runner.h"

#include <csignal>
#include <stdexcept>

namespace
{
class ToolRunner : public ToolTest
{};
} // namespace

TEST_F (ToolRunner, WhatDoesNotStartGetsNoSignals)
{
  EXPECT_THROW (RunningTool ({path ("missing")}, folder_), std::runtime_error);
  EXPECT_THROW (test_support::ChildProcess (-1), std::runtime_error);
}

TEST_F (ToolRunner, AToolThatIsLeftAloneIsKilled)
{
  pid_t number = 0;
  {
    const RunningTool tool ({"/bin/sleep", "100"}, folder_);
    number = tool.number ();
    EXPECT_EQ (kill (number, 0), 0);
  }
  EXPECT_EQ (kill (number, 0), -1);
}

TEST_F (ToolRunner, TellsHowAToolEnded)
{
  EXPECT_EQ (RunningTool ({"/bin/sh", "-c", "exit 3"}, folder_).wait ().status, 3);
  RunningTool tool ({"/bin/sleep", "100"}, folder_);
  tool.send (SIGTERM);
  EXPECT_EQ (tool.wait ().status, 128 + SIGTERM);
  EXPECT_THROW (tool.wait (), std::runtime_error);
  tool.send (SIGTERM); // has no effect
}
