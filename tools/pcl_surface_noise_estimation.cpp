// SPDX-License-Identifier: BSD-3-Clause
#include "clouds/cloud_graph.h"
#include "command_line/common_options.h"
#include "command_line/tool.h"

#include <cstdio>

using namespace pcl_normal_smoothing;

namespace
{
class SurfaceNoiseEstimationTool : public tools::Tool
{
  void
  describe (tools::Options& options) override
  {
    options.describe ("Tells how noisy a scan is: the standard deviation of its noise along the surface's normal.",
                      {"input.pcd|ply"});
    tools::addThreadsOption (options, threads_);
  }

  void
  work (const tools::Options& options) override
  {
    const tools::CloudFile file = tools::loadInput (options.file (0));
    const core::NoiseEstimate noise =
        tools::estimateNoise (file, core::Execution (threads_, tools::progressOnTerminal ()));
    if (!(noise.spacing > 0)) {
      std::printf ("no noise to be seen: neighbourhoods have fewer than 8 points or no extent\n");
      return;
    }
    std::printf ("noise sigma %.9g, spacing %.9g, in the cloud's unit: noise of %.3f spacings\n", noise.sigma,
                 noise.spacing, noise.sigma / noise.spacing);
    if (noise.field.largestFactor () > 1.05f * noise.field.smallestFactor ())
      std::printf ("it varies from place to place: sigma from %.3g to %.3g\n",
                   noise.sigma * noise.field.smallestFactor (), noise.sigma * noise.field.largestFactor ());
    if (const std::string found = tools::textOf (noise.hidden_by); !found.empty ())
      std::printf ("found: %s\n", found.c_str ());
  }

  unsigned threads_ = 0;
};
} // namespace

int
main (int argc, char** argv)
{
  SurfaceNoiseEstimationTool tool;
  return tools::runTool (argc, argv, tool);
}
