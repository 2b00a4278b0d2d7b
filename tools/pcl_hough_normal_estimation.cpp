// SPDX-License-Identifier: BSD-3-Clause
#include "clouds/normal_fields.h"
#include "command_line/common_options.h"
#include "command_line/tool.h"

#include <pcl_normal_smoothing/core/chain/surface_estimation.h>
#include <pcl_normal_smoothing/core/error.h>

using namespace pcl_normal_smoothing;

namespace
{
class HoughNormalEstimationTool : public tools::Tool
{
  void
  describe (tools::Options& options) override
  {
    options.describe ("Estimates normals by a randomised Hough transform, sharp beside edges; writes normal_x normal_y "
                      "normal_z curvature beside the other fields.",
                      {"input.pcd|ply", "output.pcd|ply"});
    search_.addTo (options, std::to_string (search_.standard_k));
    options.add ("-confidence", "A",
                 "probability with which the votes come close to their distribution, from 1e-6 to below 1",
                 core::numberText (hough_.confidence), shareOption (1e-6, hough_.confidence));
    options.add ("-tolerance", "D",
                 "how close they come, from 0.001 to below 1; the number of votes grows with its inverse square",
                 core::numberText (hough_.tolerance), shareOption (1e-3, hough_.tolerance));
    options.add ("-bands", "N", "bands of the accumulator between its poles, 2 to 1000", std::to_string (hough_.bands),
                 tools::integerOption (2, 1000, [this] (auto number) { hough_.bands = static_cast<int> (number); }));
    options.add ("-rotations", "N", "randomly rotated accumulators, 1 to 1000", std::to_string (hough_.rotations),
                 tools::integerOption (1, 1000,
                                       [this] (auto number) { hough_.rotations = static_cast<int> (number); }));
    tools::addSeedOption (options, "0", [this] (std::uint64_t seed) { hough_.seed = seed; });
    format_.addTo (options);
  }

  static tools::OptionReader
  shareOption (double least, float& target)
  {
    return tools::numberOption (least, 1, [&] (double share) { target = static_cast<float> (share); });
  }

  void
  work (const tools::Options& options) override
  {
    const core::NeighborQuery query = search_.query ();
    tools::checkOutput (options.file (1), format_.format);
    tools::CloudFile file = tools::loadInput (options.file (0));
    const core::Execution execution (search_.threads, tools::progressOnTerminal ());
    const tools::CloudGraph cloud = tools::searchNeighbors (file, query, execution.part (0, 0.05));
    const core::SurfaceEstimator estimator = core::makeEstimator (NormalSource::HOUGH, hough_);
    tools::writeSurfaces (*cloud.graph,
                          core::estimateSurfaces (*cloud.graph, cloud.nodes, estimator, execution.part (0.05, 1)),
                          file);
    tools::saveResult (file, options.file (1), format_.format);
  }

  core::HoughOptions hough_;
  tools::SearchOptions search_;
  tools::FormatOption format_;
};
} // namespace

int
main (int argc, char** argv)
{
  HoughNormalEstimationTool tool;
  return tools::runTool (argc, argv, tool);
}
