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

/** Measures how many seconds each part of some work takes. */
class Stopwatch
{
public:
  /** Ends the current part. */
  void
  lap (const std::string& name);

  /** The seconds of the parts, by name. */
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

/** The noise that smoothing in rounds used, or after the chain an estimate: sigma, its smallest and largest value and
  * the spacing, in the cloud's unit, and what hides it. */
Json
noiseOf (const CloudFile& noisy, const core::SmoothingOptions& used, const core::Execution& execution);

/** How many points have moved, and how far, in the cloud's unit: mean, root mean square and maximum over the finite
  * points. */
Json
displacementOf (const CloudFile& noisy, const CloudFile& smoothed);

/** \throw UsageError if the name does not end in .json, FileError if the file cannot be written */
void
checkReport (const std::string& path);

/** \throw FileError */
void
saveReport (const Json& report, const std::string& path);
} // namespace tools
} // namespace pcl_normal_smoothing
