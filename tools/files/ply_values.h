// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "field_values.h"
#include "ply_format.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace pcl_normal_smoothing
{
namespace tools
{
/** Reads the numbers of the data one by one. */
class PlyValues
{
public:
  PlyValues (ByteStream& data, PlyHeader::Encoding encoding) : data_ (data), encoding_ (encoding) {}

  /** \param[out] value receives the bytes of a number of type \a datatype */
  void
  read (std::uint8_t datatype, std::uint8_t* value)
  {
    if (encoding_ == PlyHeader::Encoding::ASCII) {
      const std::string_view word = nextWord (data_);
      if (!parseValue (word, datatype, value))
        throw FormatError (word.empty () ? "is truncated, its data end too early"
                                         : "has a value that is no number of its type (" + std::string (word) + ")");
      return;
    }
    const std::size_t size = sizeOfType (datatype);
    const std::string_view bytes = data_.peek (size);
    if (bytes.size () < size)
      throw FormatError ("is truncated, its data end too early");
    std::memcpy (value, bytes.data (), size);
    if (encoding_ == PlyHeader::Encoding::BIG_ENDIAN_BYTES)
      std::reverse (value, value + size);
    data_.skip (size);
  }

  /** Reads the length of the list that comes next. */
  std::size_t
  readLength (std::uint8_t datatype)
  {
    std::array<std::uint8_t, 8> bytes {}; // little-endian, like every machine that PCL runs on
    read (datatype, bytes.data ());
    std::uint64_t length;
    std::memcpy (&length, bytes.data (), sizeof length);
    if (length > data_.left ())
      throw FormatError ("is truncated or damaged, a list is longer than the file");
    return static_cast<std::size_t> (length);
  }

  /** Skips lines of text, blank ones not counted: MeshLab writes more numbers per face than its header says. */
  void
  skipLines (std::uint64_t count)
  {
    while (count > 0 && data_.left () > 0) {
      std::string_view line = nextLine (data_);
      count -= nextWord (line).empty () ? 0 : 1;
    }
    if (count > 0)
      throw FormatError ("is truncated, its data end too early");
  }

  /** Upper bound on the numbers of that type that may still follow. */
  std::uint64_t
  room (std::uint8_t datatype) const
  {
    return encoding_ == PlyHeader::Encoding::ASCII ? (data_.left () + 1) / 2 : data_.left () / sizeOfType (datatype);
  }

  /** The data to come, to be read without being skipped: enough for the largest vertex. */
  std::string_view
  ahead ()
  {
    return data_.peek (4 * max_point_bytes);
  }

private:
  ByteStream& data_;
  PlyHeader::Encoding encoding_;
};
} // namespace tools
} // namespace pcl_normal_smoothing
