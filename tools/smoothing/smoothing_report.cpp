// SPDX-License-Identifier: BSD-3-Clause
#include "smoothing_report.h"

#include "clouds/cloud_graph.h"
#include "command_line/option_readers.h"
#include "files/output_file.h"
#include "files/tool_error.h"

#include <pcl_normal_smoothing/core/noise/noise_estimate.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
const Words<core::NoiseHiddenBy> hiders {{"nothing", core::NoiseHiddenBy::NOTHING},
                                         {"layers", core::NoiseHiddenBy::LAYERS},
                                         {"lines", core::NoiseHiddenBy::LINES},
                                         {"rounding", core::NoiseHiddenBy::ROUNDING},
                                         {"width", core::NoiseHiddenBy::WIDTH}};
} // namespace

void
Stopwatch::lap (const std::string& name)
{
  const auto now = std::chrono::steady_clock::now ();
  laps_[name] = std::chrono::duration<double> (now - begin_).count ();
  begin_ = now;
}

Json
parametersAsJson (const std::string& options)
{
  Json parameters;
  std::istringstream words (options);
  for (std::string name, value; words >> name >> value;) {
    const Json number = Json::parse (value, nullptr, false);
    parameters[name.substr (1)] = number.is_discarded () ? Json (value) : number;
  }
  return parameters;
}

Json
noiseOf (const CloudFile& noisy, const core::SmoothingOptions& used, const core::Execution& execution)
{
  const core::NoiseEstimate noise = used.in_rounds ? used.rounds.noise : estimateNoise (noisy, execution);
  return {{"sigma", noise.sigma},
          {"smallest", noise.sigma * noise.field.smallestFactor ()},
          {"largest", noise.sigma * noise.field.largestFactor ()},
          {"spacing", noise.spacing},
          {"hidden_by", wordFor (hiders, noise.hidden_by)}};
}

Json
displacementOf (const CloudFile& noisy, const CloudFile& smoothed)
{
  const VectorView before = positionsOf (noisy), after = positionsOf (smoothed);
  std::size_t finite = 0, moved = 0;
  double sum = 0, squares = 0, farthest = 0;
  for (std::size_t i = 0; i < before.size; ++i) {
    const double distance = (after.layout.get (after.data, i) - before.layout.get (before.data, i)).norm ();
    if (!std::isfinite (distance))
      continue;
    ++finite;
    moved += distance > 0 ? 1 : 0;
    sum += distance;
    squares += distance * distance;
    farthest = std::max (farthest, distance);
  }
  const auto count = static_cast<double> (std::max<std::size_t> (finite, 1));
  return {{"finite_points", finite},
          {"moved_points", moved},
          {"mean", sum / count},
          {"rms", std::sqrt (squares / count)},
          {"max", farthest}};
}

void
checkReport (const std::string& path)
{
  if (extensionOf (path) != ".json")
    throw UsageError (path + ": a report is JSON: end its name in .json");
  checkWritable (path);
}

void
saveReport (const Json& report, const std::string& path)
{
  OutputFile file (path);
  // Names of files may be in any encoding; JSON is UTF-8.
  file.write (report.dump (2, ' ', false, Json::error_handler_t::replace) + "\n");
  file.commit ();
}
} // namespace tools
} // namespace pcl_normal_smoothing
