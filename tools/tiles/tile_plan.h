// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan.h"

#include <functional>
#include <optional>

namespace pcl_normal_smoothing
{
namespace tools
{
/** Limit of a tile, so that its points and those around it can be numbered in 32 bits. */
constexpr std::uint32_t most_points_of_tile = 1u << 31;

/** What `plan` is asked for. */
struct PlanRequest
{
  std::string folder;
  std::vector<std::string> files;
  /** In the unit of the files; below 0 for what is to be estimated. */
  core::SmoothingOptions options;
  core::NeighborQuery query;
  bool save_normals = false;
  /** Limit per tile, from 1 to most_points_of_tile; must be set: pointsWithin () gives as many as the memory allows `run`. */
  std::uint64_t max_points = 0;
  std::uint64_t memory = 0;
  unsigned threads = 0;
  /** What was asked for, as text. */
  std::string text;
};

/** Divides the points of files into tiles. Leaves nothing in the folder if it fails or is interrupted.
  * \param[in] parameters turns the options that were found, in the unit of the files, into a line of text
  * \throw FileError, core::Error */
Plan
makePlan (const PlanRequest& request, const std::function<std::string (const core::SmoothingOptions&)>& parameters);

/** The plan in the folder, if it was made for the same request and the files are unchanged. */
std::optional<Plan>
findPlan (const PlanRequest& request);

/** How many points of a tile `run` can smooth within some bytes of memory, with those that it needs around the
  * tile; at most most_points_of_tile. */
std::uint64_t
pointsWithin (std::uint64_t memory, const core::SmoothingOptions& options, const core::NeighborQuery& query);
} // namespace tools
} // namespace pcl_normal_smoothing
