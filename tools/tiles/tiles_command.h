// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "command_line/method_options.h"
#include "tile_merge.h"
#include "tile_plan.h"

namespace pcl_normal_smoothing
{
namespace tools
{
/** The steps of pcl_normal_smoothing_tiles, and their options. */
class TilesCommand
{
public:
  void
  addOptions (Options& options);

  /** \param[in] options the first file is the step, the second the folder of the plan, the others are sources
    * \throw UsageError, FileError, core::Error */
  void
  work (const Options& options);

private:
  void
  addPlanOptions (Options& options);

  void
  addRunOptions (Options& options);

  void
  addMergeOptions (Options& options);

  /** Reads what plan is asked to do. */
  void
  readRequest (const Options& options);

  void
  plan (const Options& options);

  void
  run (const Options& options);

  void
  merge (const Options& options);

  void
  list (const Options& options);

  /** The numbers of the tiles that -tile chooses. */
  std::vector<std::size_t>
  chosenTiles (std::size_t count) const;

  /** \throw UsageError if an option was given that the step does not know, or too many files */
  void
  requireOnly (const Options& options, const std::string& step, const std::vector<std::string>& known) const;

  MethodSettings method_;
  SearchOptions search_;
  PlanRequest request_;
  MergeRequest merge_;
  FormatOption format_;
  std::string tiles_ = "all";
  std::uint64_t memory_ = 0;
};
} // namespace tools
} // namespace pcl_normal_smoothing
