// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan.h"

namespace pcl_normal_smoothing
{
namespace tools
{
/** A file that is read at any position. */
class RandomAccessFile
{
public:
  RandomAccessFile () = default;
  ~RandomAccessFile ();

  RandomAccessFile (const RandomAccessFile&) = delete;
  RandomAccessFile&
  operator= (const RandomAccessFile&) = delete;

  /** Opens a file, and closes the previous one. \throw FileError, with \a advice */
  void
  open (const std::string& path, const std::string& advice);

  /** \return how many bytes were read, fewer than \a count only at the end of the file \throw FileError */
  std::size_t
  read (std::uint64_t begin, std::uint8_t* bytes, std::size_t count) const;

  std::uint64_t
  size () const;

  const std::string&
  path () const
  {
    return path_;
  }

private:
  std::string path_;
  int descriptor_ = -1;
};

/** Reads the points of cells from the files that `plan` wrote. */
class RecordReader
{
public:
  explicit RecordReader (const Plan& plan) : plan_ (plan) {}

  /** Appends the records of a cell. Fastest in the order of the cells. \throw FileError if a file is missing or
    * damaged */
  void
  read (std::uint32_t cell, std::vector<std::uint8_t>& records);

private:
  const Plan& plan_;
  RandomAccessFile file_;
  std::uint32_t tile_ = 0;
};
} // namespace tools
} // namespace pcl_normal_smoothing
