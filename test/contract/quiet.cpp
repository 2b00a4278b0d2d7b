// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <pcl/console/print.h>

namespace
{
/** Silences the console: tests provoke many errors and read them from getErrorMessage. */
class Quiet : public testing::Environment
{
  void
  SetUp () override
  {
    pcl::console::setVerbosityLevel (pcl::console::L_ALWAYS);
  }
};

const testing::Environment* const quiet = testing::AddGlobalTestEnvironment (new Quiet);
} // namespace
