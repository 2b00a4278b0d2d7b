// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan.h"

#include <functional>
#include <optional>

namespace pcl_normal_smoothing
{
namespace tools
{
/** What `plan` is asked for. */
struct PlanRequest
{
  std::string folder;
  std::vector<std::string> files;
  /** In the unit of the files; what is to be estimated below 0. */
  core::SmoothingOptions options;
  core::NeighborQuery query;
  bool save_normals = false;
  /** Of a tile; 0 = as many as the memory allows `run`. */
  std::uint64_t max_points = 0;
  std::uint64_t memory = 0;
  unsigned threads = 0;
  /** All of this as text. */
  std::string text;
};

/** Parts the points of files in tiles. Nothing is left in the folder where it fails or is interrupted.
  * \param[in] parameters makes a line of options of the options that were found, in the unit of the files
  * \throw FileError, core::Error */
Plan
makePlan (const PlanRequest& request, const std::function<std::string (const core::SmoothingOptions&)>& parameters);

/** The plan that is in the folder, where it is one for that request and the files are as they were. */
std::optional<Plan>
findPlan (const PlanRequest& request);

/** Points of a tile that `run` can smooth within some memory, with what a tile of a surface needs around it. */
std::uint64_t
pointsWithin (std::uint64_t memory, const core::SmoothingOptions& options, const core::NeighborQuery& query);
} // namespace tools
} // namespace pcl_normal_smoothing
