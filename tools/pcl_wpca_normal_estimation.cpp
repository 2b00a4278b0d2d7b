// SPDX-License-Identifier: BSD-3-Clause
#include "clouds/normal_fields.h"
#include "command_line/common_options.h"
#include "command_line/tool.h"

#include <pcl_normal_smoothing/core/chain/surface_estimation.h>

using namespace pcl_normal_smoothing;

namespace
{
constexpr int least_k = 4; // the point itself is left out

class WPCANormalEstimationTool : public tools::Tool
{
  void
  describe (tools::Options& options) override
  {
    options.describe (
        "Estimates normals by weighted PCA; writes normal_x normal_y normal_z curvature beside the other fields.",
        {"input.pcd|ply", "output.pcd|ply"});
    search_.addTo (options, std::to_string (search_.standard_k), least_k);
    format_.addTo (options);
  }

  void
  work (const tools::Options& options) override
  {
    const core::NeighborQuery query = search_.query ();
    tools::checkOutput (options.file (1), format_.format);
    tools::CloudFile file = tools::loadInput (options.file (0));
    const core::Execution execution (search_.threads, tools::progressOnTerminal ());
    const tools::CloudGraph cloud = tools::searchNeighbors (file, query, execution.part (0, 0.7));
    tools::writeSurfaces (*cloud.graph,
                          core::estimateSurfaces (*cloud.graph, cloud.nodes, core::wpcaSurface,
                                                  execution.part (0.7, 1)),
                          file);
    tools::saveResult (file, options.file (1), format_.format);
  }

  tools::SearchOptions search_;
  tools::FormatOption format_;
};
} // namespace

int
main (int argc, char** argv)
{
  WPCANormalEstimationTool tool;
  return tools::runTool (argc, argv, tool);
}
