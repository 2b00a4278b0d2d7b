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

/** Bytes from front to back: of a file, a megabyte of which is in memory, or such as are in memory anyway. */
class ByteStream
{
public:
  /** Bytes that stay where they are while this is used. */
  explicit ByteStream (std::string_view bytes);

  /** \throw FileError where there is no regular file that can be read */
  explicit ByteStream (const std::filesystem::path& path);

  ~ByteStream ();

  ByteStream (const ByteStream&) = delete;
  ByteStream&
  operator= (const ByteStream&) = delete;

  /** What comes next: at least \a least bytes, fewer only where no more are left. Valid until the next peek.
    * \throw FileError where the file cannot be read */
  std::string_view
  peek (std::size_t least = 1)
  {
    if (ahead_.size () < least && ahead_.size () < left_)
      refill (least);
    return ahead_;
  }

  /** Goes past \a count bytes that peek has shown. */
  void
  skip (std::size_t count)
  {
    count = std::min (count, ahead_.size ());
    ahead_.remove_prefix (count);
    left_ -= count;
  }

  /** How many bytes are still to come. */
  std::uint64_t
  left () const
  {
    return left_;
  }

  /** Of all bytes of the file that have been read so far. */
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

/** The next word, as nextWord of a text. Valid until the next peek. */
std::string_view
nextWord (ByteStream& stream);

/** The next line, as nextLine of a text. Valid until the next peek. */
std::string_view
nextLine (ByteStream& stream);
} // namespace tools
} // namespace pcl_normal_smoothing
