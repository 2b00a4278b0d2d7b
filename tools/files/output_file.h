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
  * It is written under a temporary name in the same folder; if it is destroyed before commit(), nothing is left behind
  * and an old file stays as it was. Symbolic links are followed. A pipe or a device is written to directly: there is
  * nothing to replace. Only one may exist at a time in a process: the signal handler knows one temporary file. */
class OutputFile
{
public:
  /** \throw FileError if the file cannot be written there */
  explicit OutputFile (const std::string& path);

  ~OutputFile ();

  OutputFile (const OutputFile&) = delete;
  OutputFile&
  operator= (const OutputFile&) = delete;

  /** \throw FileError if the disk is full */
  void
  write (std::string_view bytes);

  /** Puts the file in its place. \throw FileError if that fails */
  void
  commit ();

private:
  void
  flush ();

  [[noreturn]] void
  fail (const std::string& action);

  std::string path_;      // as the user gave it, for messages
  std::string target_;    // with symbolic links resolved
  std::string temporary_; // empty if the target is written to directly
  std::string buffer_;
  int descriptor_ = -1;
};

/** Checks, before the work is done, that its result can be written: that the folder exists, that the name is not a
  * folder's, that there are sufficient rights. \throw FileError */
void
checkWritable (const std::string& path);

/** Registers a file, or a folder that is empty by then, to be removed together with the temporary file if the tool is
  * interrupted. For what is of no use until other files are written. */
void
removeOnInterruption (const std::string& path);

/** Cancels what removeOnInterruption has registered. */
void
keepOnInterruption () noexcept;

/** Removes the temporary file of the current OutputFile, and what removeOnInterruption has registered. Safe in a
  * signal handler. */
void
removeTemporaryFile () noexcept;
} // namespace tools
} // namespace pcl_normal_smoothing
