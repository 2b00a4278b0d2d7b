// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace pcl_normal_smoothing::evaluation
{

/** Reserves a folder for one process: two studies would overwrite each other's rows. Released when the process ends,
  * however it ends. */
class FolderLock
{
public:
  /** \throw FileError if another process holds the folder, or there is none */
  explicit FolderLock (const std::string& folder);

  ~FolderLock ();

  FolderLock (const FolderLock&) = delete;
  FolderLock&
  operator= (const FolderLock&) = delete;

private:
  int folder_;
};

} // namespace pcl_normal_smoothing::evaluation
