// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan.h"

namespace pcl_normal_smoothing
{
namespace tools
{
/** What it took to smooth a tile. */
struct TileRun
{
  std::uint64_t points = 0;
  /** Points of other tiles that were loaded with it. */
  std::uint64_t around = 0;
  /** How often neighbours were searched until nothing was missing. */
  std::uint64_t searches = 0;
};

/** Smooths a tile of a plan as a run over the whole cloud would, and writes its result.
  * \throw FileError, core::Error; no result is written then */
TileRun
runTile (const Plan& plan, std::size_t tile, unsigned threads);
} // namespace tools
} // namespace pcl_normal_smoothing
