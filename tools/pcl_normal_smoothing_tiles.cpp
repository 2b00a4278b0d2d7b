// SPDX-License-Identifier: BSD-3-Clause
#include "command_line/tool.h"
#include "tiles/tiles_command.h"

using namespace pcl_normal_smoothing;

namespace
{
class NormalSmoothingTilesTool : public tools::Tool
{
  void
  describe (tools::Options& options) override
  {
    command_.addOptions (options);
  }

  void
  work (const tools::Options& options) override
  {
    command_.work (options);
  }

  tools::TilesCommand command_;
};
} // namespace

int
main (int argc, char** argv)
{
  NormalSmoothingTilesTool tool;
  return tools::runTool (argc, argv, tool);
}
