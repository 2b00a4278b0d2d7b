// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "results/folder_lock.h"
#include "results/row.h"

#include <chrono>
#include <unordered_map>
#include <vector>

namespace pcl_normal_smoothing::evaluation
{

/** The rows of a study, in its folder as rows.csv and rows.json: both always complete files, a few seconds behind the
  * work. What an earlier, interrupted study has left there is taken up. */
class Results
{
public:
  /** \param[in] folder exists \throw FileError where rows.json is there but cannot be read, or another study is at
    * work */
  explicit Results (const std::string& folder);

  /** The row of that key; nullptr where there is none. Valid until the next put. */
  const Row*
  find (const std::string& key) const;

  /** Whether that question is answered; one that failed or whose peer was absent is asked again by the next study. */
  bool
  answered (const std::string& key) const;

  /** Adds the row, or puts it in the place of that with the same key; saves now and then. */
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
  bool said_ = false; // that it cannot be saved
};

} // namespace pcl_normal_smoothing::evaluation
