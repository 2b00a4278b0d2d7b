// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_graph.h"
#include "method_options.h"
#include "tool.h"

#include <pcl_normal_smoothing/core/error.h>
#include <pcl_normal_smoothing/normal_smoothing.h>

using namespace pcl_normal_smoothing;

namespace
{
class Smoothing : public NormalSmoothing<pcl::PCLPointCloud2>
{
public:
  using SmoothingSettings::presetK;
};

class NormalSmoothingTool : public tools::Tool
{
  void
  describe (tools::Options& options) override
  {
    options.describe (std::string (
                          "Smooths the points of a noisy surface without rounding its edges; keeps every other "
                          "field.\n") +
                          tools::presets_and_chain,
                      {"input.pcd|ply", "output.pcd|ply"});
    tools::addPresetOptions (options, smoothing_);
    search_.addTo (options, tools::presetStandardK ());
    tools::addFilterOptions (options, tools::presetStandard, smoothing_);
    tools::addUpdateOptions (options, tools::presetStandard, smoothing_);
    tools::addNoiseOptions (options, smoothing_);
    tools::addOrientedOption (options, smoothing_);
    options.add ("-save_normals", "0|1", "1: write the normals that the points fit to normal_x normal_y normal_z", "0",
                 tools::switchOption ([this] (bool save) { smoothing_.setSaveNormals (save); }));
    tools::addSeedOption (options, "0", [this] (std::uint64_t seed) { smoothing_.setSeed (seed); });
    format_.addTo (options);
  }

  void
  work (const tools::Options& options) override
  {
    const core::NeighborQuery query = search_.query (smoothing_.presetK ());
    tools::checkOptions (smoothing_.options ());
    tools::checkOutput (options.file (1), format_.format);
    tools::CloudFile file = tools::loadInput (options.file (0));
    tools::checkPointCount (core::finiteElements (readPositions (tools::positionsOf (file))).size (), query.k);
    if (smoothing_.options ().normals == NormalSource::INPUT)
      tools::normalLayoutOf (file, tools::normals_advice);
    if (smoothing_.getSaveNormals ())
      tools::addNormalFields (file);
    smoothing_.setKSearch (static_cast<int> (query.k));
    smoothing_.setRadiusSearch (search_.radius);
    smoothing_.setMaxNeighborDistance (search_.max_radius);
    smoothing_.setNumberOfThreads (search_.threads);
    smoothing_.setProgressCallback (tools::progressOnTerminal ());
    smoothing_.setInputCloud (file.cloud);
    file.cloud = pcl::make_shared<pcl::PCLPointCloud2> ();
    smoothing_.filter (*file.cloud);
    if (!smoothing_.getErrorMessage ().empty ())
      throw core::Error (smoothing_.getErrorMessage ());
    tools::saveResult (file, options.file (1), format_.format);
    tools::printParameters (options.file (0), smoothing_.getPreset (), smoothing_.usedOptions (), search_,
                            smoothing_.presetK ());
  }

  Smoothing smoothing_;
  tools::SearchOptions search_;
  tools::FormatOption format_;
};
} // namespace

int
main (int argc, char** argv)
{
  NormalSmoothingTool tool;
  return tools::runTool (argc, argv, tool);
}
