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
  /** One of these: a folder for files with the names of the sources; one file; a folder for a file of every tile. */
  std::string output_folder, output, tile_folder;
  FileFormat format = FileFormat::BINARY;
  std::uint64_t memory = 0;
};

/** Puts the results of tiles in the place of the points of the sources, with their order and all other fields.
  * \throw FileError where a result or a source is missing, damaged or has changed; core::Error where no point had a
  * normal */
void
mergeTiles (const Plan& plan, const MergeRequest& request);

/** The tiles without a result that is complete.
  * \param[out] with_normal points that had a normal to begin with */
std::vector<std::size_t>
unfinishedTiles (const Plan& plan, std::uint64_t& with_normal);
} // namespace tools
} // namespace pcl_normal_smoothing
