// SPDX-License-Identifier: BSD-3-Clause
#include "clouds/normal_fields.h"
#include "command_line/method_options.h"
#include "command_line/tool.h"

#include <pcl_normal_smoothing/bilateral_normal_filter.h>

using namespace pcl_normal_smoothing;

namespace
{
class BilateralNormalFilterTool : public tools::Tool
{
  void
  describe (tools::Options& options) override
  {
    options.describe ("Filters the normals of a cloud and keeps the edges between them; points and other fields stay.",
                      {"input.pcd|ply", "output.pcd|ply"});
    const BilateralNormalFilter<pcl::PointNormal> standard;
    settings_.setNormalWeight (standard.getNormalWeight ());
    settings_.setMixedThreshold (standard.getMixedThreshold ());
    settings_.setThreshold (standard.getThreshold ());
    settings_.setSigmaS (standard.getSigmaS ());
    settings_.setNormalIterations (standard.getMaxIterations ());
    search_.addTo (options, std::to_string (search_.standard_k));
    tools::addFilterOptions (options, tools::standardOf (settings_), settings_);
    tools::addOrientedOption (options, settings_);
    format_.addTo (options);
  }

  void
  work (const tools::Options& options) override
  {
    const core::NeighborQuery query = search_.query ();
    tools::checkOutput (options.file (1), format_.format);
    tools::CloudFile file = tools::loadInput (options.file (0));
    const VectorLayout layout = tools::normalLayoutOf (file, tools::normals_advice);
    const core::Execution execution (search_.threads, tools::progressOnTerminal ());
    const tools::CloudGraph cloud = tools::searchNeighbors (file, query, execution.part (0, 0.7));
    std::uint8_t* data = file.cloud->data.data ();
    core::Vectors normals = tools::loadNormals (*cloud.graph, layout, file);
    core::filterNormals (*cloud.graph, cloud.nodes, settings_.options ().filter, execution.part (0.7, 1), normals);
    writeNormals (normals, cloud.graph->order (), std::vector<bool> (file.size (), true), layout, data);
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
  BilateralNormalFilterTool tool;
  return tools::runTool (argc, argv, tool);
}
