// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace pcl_normal_smoothing
{
namespace tools
{
class Checksum;

/** Reads bytes from front to back: those of a file, about a megabyte at a time, or bytes in memory. */
class ByteStream
{
public:
  /** \param[in] bytes must stay in place while this is used */
  explicit ByteStream (std::string_view bytes);

  /** \throw FileError unless the path names a regular file that can be read */
  explicit ByteStream (const std::filesystem::path& path);

  ~ByteStream ();

  ByteStream (const ByteStream&) = delete;
  ByteStream&
  operator= (const ByteStream&) = delete;

  /** The next bytes, which are not skipped: at least \a least, fewer only at the end. Valid until the next peek.
    * \throw FileError if the file cannot be read */
  std::string_view
  peek (std::size_t least = 1)
  {
    if (ahead_.size () < least && ahead_.size () < left_)
      refill (least);
    return ahead_;
  }

  /** Skips \a count bytes that peek has returned. */
  void
  skip (std::size_t count)
  {
    count = std::min (count, ahead_.size ());
    ahead_.remove_prefix (count);
    left_ -= count;
  }

  /** The number of bytes still to come. */
  std::uint64_t
  left () const
  {
    return left_;
  }

  /** Checksum of all bytes read from the file so far. Only for the stream of a file. */
  std::string
  checksum () const;

private:
  void
  refill (std::size_t least);

  std::string path_;
  int descriptor_ = -1;
  std::string buffer_;
  std::string_view ahead_;
  std::uint64_t left_ = 0;
  std::unique_ptr<Checksum> checksum_;
};

/** The next word, as nextWord of field_values.h. Valid until the next peek. */
std::string_view
nextWord (ByteStream& stream);

/** The next line, as nextLine of field_values.h. Valid until the next peek. */
std::string_view
nextLine (ByteStream& stream);
} // namespace tools
} // namespace pcl_normal_smoothing
