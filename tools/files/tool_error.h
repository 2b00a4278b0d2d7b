// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace pcl_normal_smoothing
{
namespace tools
{
/** The command line cannot be understood: exit status 1. */
struct UsageError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/** A file cannot be read or written: exit status 2. For data that cannot be processed there is core::Error: exit
  * status 3. */
struct FileError : std::runtime_error
{
  /** \param[in] what the problem
    * \param[in] advice what to do about it */
  FileError (const std::string& file, const std::string& what, const std::string& advice)
  : std::runtime_error (file + ": " + what + ": " + advice)
  {}
};

/** Bytes violate their format, or a format cannot hold a cloud. Callers that know the file name turn it into a
  * FileError. */
struct FormatError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};
} // namespace tools
} // namespace pcl_normal_smoothing
