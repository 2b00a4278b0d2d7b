// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "results/folder_lock.h"
#include "results/row.h"

#include <chrono>
#include <unordered_map>
#include <vector>

namespace pcl_normal_smoothing::evaluation
{

/** The rows of a study, in its folder as rows.csv and rows.json: always complete files, a few seconds behind the work.
  * Starts with the rows that an earlier, interrupted study left there. */
class Results
{
public:
  /** \param[in] folder must exist \throw FileError if rows.json exists but cannot be read, or another study uses the
    * folder */
  explicit Results (const std::string& folder);

  /** The row with that key; nullptr if there is none. Valid until the next put. */
  const Row*
  find (const std::string& key) const;

  /** Whether the row with that key has a result; failed and absent ones are tried again by the next study. */
  bool
  answered (const std::string& key) const;

  /** Adds the row or replaces the one with the same key; saves from time to time. */
  void
  put (const Row& row);

  const std::vector<Row>&
  rows () const
  {
    return rows_;
  }

  /** Writes both files. \throw FileError */
  void
  save ();

private:
  void
  load ();

  std::string folder_;
  FolderLock lock_;
  std::vector<Row> rows_;
  std::unordered_map<std::string, std::size_t> places_;
  std::chrono::steady_clock::time_point saved_ = std::chrono::steady_clock::now ();
  bool said_ = false; // whether a failure to save was reported
};

} // namespace pcl_normal_smoothing::evaluation
