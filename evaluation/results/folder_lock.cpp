// SPDX-License-Identifier: BSD-3-Clause
#include "results/folder_lock.h"
#include "files/tool_error.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

namespace pcl_normal_smoothing::evaluation
{

FolderLock::FolderLock (const std::string& folder)
: folder_ (open (folder.c_str (), O_RDONLY | O_DIRECTORY | O_CLOEXEC))
{
  if (folder_ < 0)
    throw tools::FileError (folder, "cannot be opened", "give a folder that can be read");
  // On file systems without locks, go on without one.
  if (flock (folder_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    close (folder_);
    throw tools::FileError (folder, "another study is at work in it", "wait for it, or give another folder");
  }
}

FolderLock::~FolderLock ()
{
  close (folder_);
}

} // namespace pcl_normal_smoothing::evaluation
