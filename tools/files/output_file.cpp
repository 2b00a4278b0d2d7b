// SPDX-License-Identifier: BSD-3-Clause
#include "output_file.h"

#include "signal_pause.h"
#include "tool_error.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <vector>

namespace fs = std::filesystem;

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
constexpr std::size_t buffer_size = 1u << 20;

// What the signal handler may access.
char temporary_path[PATH_MAX];
volatile std::sig_atomic_t has_temporary = 0;

struct Removed
{
  std::string path;
  Removed* before;
};

std::atomic<Removed*> removed {nullptr};

void
removeOwnTemporary () noexcept
{
  if (has_temporary)
    unlink (temporary_path);
  has_temporary = 0;
}

/** Follows symbolic links, even if the last one points to a file that does not exist yet. */
fs::path
behindLinks (fs::path path)
{
  std::error_code error;
  for (int links = 0; links < 40 && fs::is_symlink (fs::symlink_status (path, error)); ++links) {
    const fs::path next = fs::read_symlink (path, error);
    path = next.is_absolute () ? next : path.parent_path () / next;
  }
  return path;
}

std::string
folderOf (const fs::path& path)
{
  return path.has_parent_path () ? path.parent_path ().string () : ".";
}

/** The rights of the old file if one is replaced, otherwise those that the user's umask gives. */
mode_t
rightsOf (const std::string& target)
{
  struct stat status;
  if (stat (target.c_str (), &status) == 0)
    return status.st_mode & 07777;
  const mode_t mask = umask (0);
  umask (mask);
  return 0666 & ~mask;
}

bool
existsButIsNoFile (const std::string& target)
{
  struct stat status;
  return stat (target.c_str (), &status) == 0 && !S_ISREG (status.st_mode);
}
} // namespace

void
checkWritable (const std::string& path)
{
  const fs::path target = behindLinks (path);
  const std::string folder = folderOf (target);
  std::error_code error;
  if (!fs::is_directory (folder, error))
    throw FileError (path, "the folder " + folder + " does not exist", "make it first, or name another output");
  if (fs::is_directory (target, error))
    throw FileError (path, "is a folder", "name a file in it");
  const bool exists = fs::exists (target, error);
  if (exists && access (target.c_str (), W_OK) != 0)
    throw FileError (path, "cannot be written (" + std::string (std::strerror (errno)) + ")",
                     "change its rights, or name another output");
  if (!existsButIsNoFile (target) && access (folder.c_str (), W_OK) != 0)
    throw FileError (path, "the folder " + folder + " cannot be written to (" + std::strerror (errno) + ")",
                     "change its rights, or name another output");
}

OutputFile::OutputFile (const std::string& path) : path_ (path), target_ (behindLinks (path).string ())
{
  checkWritable (path);
  if (existsButIsNoFile (target_)) {
    descriptor_ = open (target_.c_str (), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0)
      fail ("cannot be opened");
    return;
  }
  const std::string extension = fs::path (target_).extension ().string ();
  std::string name = target_.substr (0, target_.size () - extension.size ()) + ".XXXXXX" + extension;
  if (name.size () >= sizeof temporary_path)
    throw FileError (path, "the name is too long", "name a shorter output");
  const SignalPause pause;
  descriptor_ = mkostemps (name.data (), static_cast<int> (extension.size ()), O_CLOEXEC);
  if (descriptor_ < 0)
    fail ("cannot be created");
  temporary_ = name;
  std::memcpy (temporary_path, name.c_str (), name.size () + 1);
  has_temporary = 1;
  fchmod (descriptor_, rightsOf (target_));
}

OutputFile::~OutputFile ()
{
  if (descriptor_ >= 0)
    close (descriptor_);
  if (!temporary_.empty ())
    removeOwnTemporary ();
}

void
OutputFile::write (std::string_view bytes)
{
  buffer_.append (bytes);
  if (buffer_.size () >= buffer_size)
    flush ();
}

void
OutputFile::flush ()
{
  std::size_t done = 0;
  while (done < buffer_.size ()) {
    const ssize_t written = ::write (descriptor_, buffer_.data () + done, buffer_.size () - done);
    if (written < 0 && errno != EINTR)
      fail ("cannot be written");
    if (written > 0)
      done += static_cast<std::size_t> (written);
  }
  buffer_.clear ();
}

void
OutputFile::commit ()
{
  flush ();
  if (temporary_.empty ())
    return;
  if (fsync (descriptor_) != 0)
    fail ("cannot be written");
  const int descriptor = descriptor_;
  descriptor_ = -1;
  if (close (descriptor) != 0) // network file systems report a full disk here
    fail ("cannot be written");
  const SignalPause pause;
  if (std::rename (temporary_.c_str (), target_.c_str ()) != 0)
    fail ("cannot be put in its place");
  has_temporary = 0;
}

void
OutputFile::fail (const std::string& action)
{
  const int reason = errno;
  const bool full = reason == ENOSPC || reason == EDQUOT || reason == EFBIG;
  throw FileError (path_, action + " (" + std::strerror (reason) + ")",
                   full ? "free some space, or name an output on another disk" : "name another output");
}

void
removeOnInterruption (const std::string& path)
{
  removed = new Removed {path, removed}; // never freed: a signal may come at any time
}

void
keepOnInterruption () noexcept
{
  removed = nullptr;
}

void
removeTemporaryFile () noexcept
{
  removeOwnTemporary ();
  for (const Removed* file = removed.exchange (nullptr); file; file = file->before)
    if (unlink (file->path.c_str ()) != 0)
      rmdir (file->path.c_str ());
}
} // namespace tools
} // namespace pcl_normal_smoothing
