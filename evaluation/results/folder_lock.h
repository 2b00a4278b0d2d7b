// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace pcl_normal_smoothing::evaluation
{

/** Keeps a folder for one process: two studies would overwrite each other's rows. Goes with the process, however that
  * ends. */
class FolderLock
{
public:
  /** \throw FileError where another process has the folder, or there is none */
  explicit FolderLock (const std::string& folder);

  ~FolderLock ();

  FolderLock (const FolderLock&) = delete;
  FolderLock&
  operator= (const FolderLock&) = delete;

private:
  int folder_;
};

} // namespace pcl_normal_smoothing::evaluation
