// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace pcl_normal_smoothing
{
namespace tools
{
/** A file that appears, or replaces the one of that name, only when it is complete.
  *
  * It grows under a temporary name beside its place; destroyed before commit(), it leaves nothing behind and the old
  * file as it was. A symbolic link is followed. A pipe or a device is written to at once: there is nothing to replace.
  * One at a time in a process: its signal handler removes the temporary file of the last. */
class OutputFile
{
public:
  /** \throw FileError where the place cannot be written to */
  explicit OutputFile (const std::string& path);

  ~OutputFile ();

  OutputFile (const OutputFile&) = delete;
  OutputFile&
  operator= (const OutputFile&) = delete;

  /** \throw FileError where the disk is full */
  void
  write (std::string_view bytes);

  /** Puts the file in its place. \throw FileError where that fails */
  void
  commit ();

private:
  void
  flush ();

  [[noreturn]] void
  fail (const std::string& action);

  std::string path_;      // as the user gave it, for messages
  std::string target_;    // behind symbolic links
  std::string temporary_; // empty where the target is written to directly
  std::string buffer_;
  int descriptor_ = -1;
};

/** Finds out before the work what would make it useless after: a missing folder, a folder in the file's place, missing
  * rights. \throw FileError */
void
checkWritable (const std::string& path);

/** Removes a file, or a folder once it is empty, together with the temporary file: what is of no use until other files
  * are written. */
void
removeOnInterruption (const std::string& path);

/** Keeps what was to be removed. */
void
keepOnInterruption () noexcept;

/** Removes the temporary file of the OutputFile at work, and what removeOnInterruption names. Safe in a signal
  * handler. */
void
removeTemporaryFile () noexcept;
} // namespace tools
} // namespace pcl_normal_smoothing
