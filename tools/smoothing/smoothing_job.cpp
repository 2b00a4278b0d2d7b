// SPDX-License-Identifier: BSD-3-Clause
#include "smoothing_job.h"

#include "clouds/cloud_graph.h"
#include "clouds/cloud_of_points.h"
#include "command_line/option_notes.h"
#include "command_line/tool.h"
#include "smoothing_report.h"

#include <pcl_normal_smoothing/core/error.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
// Fewer points show no noise: the fit to a neighbourhood is exact, or nearly so.
constexpr std::size_t least_points = 10;
// Ratio of sigma to the spacing. Estimates of the noise never reach it.
constexpr float absurd_ratio = 10;

/** A message if float is too coarse for coordinates as far from the origin as these; otherwise empty.
  * \param[in] spacing 0: unknown */
std::string
coarsenessOf (const CloudFile& file, double spacing)
{
  const VectorView points = positionsOf (file);
  if (points.layout.scalar () != VectorLayout::Scalar::FLOAT32)
    return {};
  double farthest = 0;
  for (std::size_t i = 0; i < points.size; ++i)
    if (const Eigen::Vector3d point = points.layout.get (points.data, i); point.allFinite ())
      farthest = std::max (farthest, point.cwiseAbs ().maxCoeff ());
  const double step = floatStep (farthest);
  if (!(spacing > 0) || step <= spacing / 4)
    return {};
  std::ostringstream text;
  text << "coordinates of " << farthest << " come in steps of " << step
       << " in float: give them as double, or less a common offset";
  return text.str ();
}
} // namespace

void
SmoothingJob::addOptions (Options& options)
{
  addMethodOptions (options, smoothing_, search_, [this] (bool save) { smoothing_.setSaveNormals (save); });
  addWideningOption (options, smoothing_);
  format_.addTo (options);
}

void
SmoothingJob::check (const Options& options) const
{
  query ();
  checkOptions (smoothing_.options (), search_.k);
  noteSurprises (options, smoothing_.options (), search_.k);
}

void
SmoothingJob::prepare (CloudFile& file) const
{
  checkPointCount (core::finiteElements (readPositions (positionsOf (file))).size (), query ().k);
  if (smoothing_.options ().normals == NormalSource::INPUT)
    normalLayoutOf (file, normals_advice);
  if (!smoothing_.getSaveNormals ())
    return;
  file.cloud = pcl::make_shared<pcl::PCLPointCloud2> (*file.cloud);
  addNormalFields (file);
}

void
SmoothingJob::run (CloudFile& file,
                   unsigned threads,
                   const ProgressCallback& progress,
                   const core::NeighborGraph::ConstPtr& graph)
{
  smoothing_.setNeighborGraph (graph);
  smoothing_.setKSearch (static_cast<int> (query ().k));
  smoothing_.setRadiusSearch (search_.radius);
  smoothing_.setMaxNeighborDistance (search_.max_radius);
  smoothing_.setNumberOfThreads (threads);
  smoothing_.setProgressCallback (progress);
  smoothing_.setInputCloud (file.cloud);
  const auto smoothed = pcl::make_shared<pcl::PCLPointCloud2> ();
  smoothing_.filter (*smoothed);
  if (!smoothing_.getErrorMessage ().empty ())
    throw core::Error (smoothing_.getErrorMessage ());
  noteTrouble (file);
  file.cloud = smoothed;
}

void
SmoothingJob::noteTrouble (const CloudFile& input) const
{
  const core::SmoothingOptions& used = smoothing_.usedOptions ();
  if (!used.in_rounds)
    return;
  const core::NoiseEstimate& noise = used.rounds.noise;
  if (const std::string coarseness = coarsenessOf (input, noise.spacing); !coarseness.empty ())
    note (input.path + ": " + coarseness);
  else if (used.rounds.count > 0 && noise.sigma == 0 && smoothing_.options ().rounds.noise.sigma < 0)
    note (input.path + (input.size () < least_points ? ": so few points show no noise" : ": no noise was found") +
          ", nothing moves: give -noise_sigma if there is some");
  else if (noise.spacing > 0 && noise.sigma > absurd_ratio * noise.spacing)
    note (input.path + ": a noise of " + core::numberText (noise.sigma / noise.spacing) +
          " times the distance between points is far too large to be smoothed: is -noise_sigma in the cloud's unit?");
}

std::string
SmoothingJob::parameters () const
{
  return asOptions (smoothing_.getPreset (), smoothing_.usedOptions (), search_, smoothing_.presetK ());
}

SmoothingResult
SmoothingJob::smooth (const std::string& input,
                      const std::string& output,
                      unsigned threads,
                      const ProgressCallback& progress,
                      bool with_report)
{
  Stopwatch stopwatch;
  checkOutput (output, format_.format);
  CloudFile file = loadInput (input);
  prepare (file);
  const CloudFile noisy = file;
  stopwatch.lap ("read");
  run (file, threads, progress);
  stopwatch.lap ("smooth");
  saveCloud (file, output, format_.format);
  stopwatch.lap ("write");
  SmoothingResult result {file.size (), parameters (), textOf (smoothing_.usedOptions ().rounds.noise.hidden_by), {}};
  if (!with_report)
    return result;
  result.report = Json {{"input", input}, {"output", output}, {"version", version ()}, {"points", result.points}};
  result.report["parameters"] = parametersAsJson (result.parameters);
  result.report["noise"] = noiseOf (noisy, smoothing_.usedOptions (), core::Execution (threads));
  result.report["displacement"] = displacementOf (noisy, file);
  result.report["seconds"] = stopwatch.laps ();
  return result;
}
} // namespace tools
} // namespace pcl_normal_smoothing
