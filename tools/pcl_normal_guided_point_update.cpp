// SPDX-License-Identifier: BSD-3-Clause
#include "clouds/normal_fields.h"
#include "command_line/method_options.h"
#include "command_line/tool.h"

#include <pcl_normal_smoothing/normal_guided_point_update.h>

using namespace pcl_normal_smoothing;

namespace
{
class NormalGuidedPointUpdateTool : public tools::Tool
{
  void
  describe (tools::Options& options) override
  {
    options.describe ("Moves the points of a cloud to fit their normals; normals and other fields stay.",
                      {"input.pcd|ply", "output.pcd|ply"});
    const NormalGuidedPointUpdate<pcl::PointNormal> standard;
    settings_.setUpdateRule (standard.getUpdateRule ());
    settings_.setUpdateSigmaS (standard.getSigmaS ());
    settings_.setPointIterations (standard.getMaxIterations ());
    settings_.setMaxDisplacement (standard.getMaxDisplacement ());
    search_.addTo (options, std::to_string (search_.standard_k));
    tools::addUpdateOptions (options, tools::standardOf (settings_), settings_);
    tools::addMotionOptions (options, "iterations", tools::standardOf (settings_), settings_);
    tools::addOrientedOption (options, settings_);
    format_.addTo (options);
  }

  void
  work (const tools::Options& options) override
  {
    const core::NeighborQuery query = search_.query ();
    tools::checkOutput (options.file (1), format_.format);
    tools::CloudFile file = tools::loadInput (options.file (0));
    const VectorLayout normals = tools::normalLayoutOf (file, tools::normals_advice);
    const core::Execution execution (search_.threads, tools::progressOnTerminal ());
    tools::CloudGraph cloud = tools::searchNeighbors (file, query, execution.part (0, 0.7));
    std::uint8_t* data = file.cloud->data.data ();
    const core::Elements& order = cloud.graph->order ();
    const core::Vectors start = core::startOf (cloud.nodes);
    core::updatePoints (cloud.graph, tools::loadNormals (*cloud.graph, normals, file),
                        settings_.options ().update.inUnit (cloud.nodes.unit), {}, execution.part (0.7, 1),
                        cloud.nodes);
    writeDisplacements (core::displacements (start, cloud.nodes), cloud.nodes.unit, order,
                        std::vector<bool> (file.size (), true), tools::positionsOf (file).layout, data);
    tools::saveResult (file, options.file (1), format_.format);
  }

  tools::MethodSettings settings_;
  tools::SearchOptions search_;
  tools::FormatOption format_;
};
} // namespace

int
main (int argc, char** argv)
{
  NormalGuidedPointUpdateTool tool;
  return tools::runTool (argc, argv, tool);
}
