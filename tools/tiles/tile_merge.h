// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan.h"

namespace pcl_normal_smoothing
{
namespace tools
{
/** What `merge` is asked for. */
struct MergeRequest
{
  /** One of these is set: a folder for files named like the sources; one file; a folder for one file per tile. */
  std::string output_folder, output, tile_folder;
  FileFormat format = FileFormat::BINARY;
  std::uint64_t memory = 0;
};

/** Writes the points of the sources as the results of the tiles have them, in their order and with all other fields.
  * \throw FileError if a result or a source is missing, damaged or has changed; core::Error if no point had a
  * normal */
void
mergeTiles (const Plan& plan, const MergeRequest& request);

/** The tiles without a complete result.
  * \param[out] with_normal points that had a normal to begin with, if all tiles are complete */
std::vector<std::size_t>
unfinishedTiles (const Plan& plan, std::uint64_t& with_normal);
} // namespace tools
} // namespace pcl_normal_smoothing
