// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "files/cloud_io.h"

#include <pcl_normal_smoothing/core/smoothing.h>

#include <nlohmann/json.hpp>

#include <chrono>

namespace pcl_normal_smoothing
{
namespace tools
{
using Json = nlohmann::ordered_json;

/** Seconds that the parts of some work take. */
class Stopwatch
{
public:
  /** Ends a part. */
  void
  lap (const std::string& name);

  /** The parts by their names. */
  const Json&
  laps () const
  {
    return laps_;
  }

private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now ();
  Json laps_;
};

/** "-k 32 -seed 0" as {"k": 32, "seed": 0}. */
Json
parametersAsJson (const std::string& options);

/** The noise that smoothing in rounds used, or else an estimate of it: sigma and spacing, in the cloud's unit. */
Json
noiseOf (const CloudFile& noisy, const core::SmoothingOptions& used, const core::Execution& execution);

/** How far points have moved, in the cloud's unit: how many, and mean, root mean square and farthest over the
  * finite. */
Json
displacementOf (const CloudFile& noisy, const CloudFile& smoothed);

/** \throw UsageError where the name does not end in .json, FileError where it cannot be written */
void
checkReport (const std::string& path);

/** \throw FileError */
void
saveReport (const Json& report, const std::string& path);
} // namespace tools
} // namespace pcl_normal_smoothing
