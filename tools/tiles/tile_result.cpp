// SPDX-License-Identifier: BSD-3-Clause
#include "tile_result.h"

#include "files/checksum.h"
#include "files/tool_error.h"

#include <algorithm>
#include <filesystem>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
/** Beginning of a result file; after the records follows a checksum of everything before it. */
struct Header
{
  char magic[8];
  char plan[16];
  std::uint64_t tile;
  std::uint64_t points;
  std::uint64_t with_normal;
};

Header
headerOf (const Plan& plan, std::size_t tile)
{
  Header header {{'P', 'N', 'S', 'T', 'I', 'L', 'E', '1'}, {}, tile, plan.tiles[tile].points, 0};
  std::copy_n (plan.id.begin (), std::min (plan.id.size (), sizeof header.plan), header.plan);
  return header;
}

template <typename T>
std::string_view
bytesOf (const T& value)
{
  return {reinterpret_cast<const char*> (&value), sizeof value};
}
} // namespace

void
saveResult (const Plan& plan, std::size_t tile, const std::vector<std::uint8_t>& records, std::uint64_t with_normal)
{
  Header header = headerOf (plan, tile);
  header.with_normal = with_normal;
  const std::string_view body (reinterpret_cast<const char*> (records.data ()), records.size ());
  Checksum checksum;
  checksum.add (bytesOf (header));
  checksum.add (body);
  OutputFile file (plan.resultPath (tile));
  file.write (bytesOf (header));
  file.write (body);
  file.write (bytesOf (checksum.value ()));
  file.commit ();
}

ResultState
checkResult (const Plan& plan, std::size_t tile, std::uint64_t& with_normal)
{
  const std::string path = plan.resultPath (tile);
  std::error_code error;
  if (!std::filesystem::exists (path, error))
    return ResultState::MISSING;
  RandomAccessFile file;
  file.open (path, "see to the disk");
  Header header {};
  file.read (0, reinterpret_cast<std::uint8_t*> (&header), sizeof header);
  with_normal = header.with_normal;
  Header expected = headerOf (plan, tile);
  expected.with_normal = header.with_normal;
  const std::uint64_t end = sizeof header + header.points * plan.result.bytes ();
  if (bytesOf (header) != bytesOf (expected) || file.size () != end + sizeof (std::uint64_t))
    return ResultState::DAMAGED;
  Checksum checksum;
  std::vector<std::uint8_t> bytes (1u << 20);
  for (std::uint64_t at = 0; at < end; at += bytes.size ()) {
    const auto count = static_cast<std::size_t> (std::min<std::uint64_t> (bytes.size (), end - at));
    checksum.add ({reinterpret_cast<const char*> (bytes.data ()), file.read (at, bytes.data (), count)});
  }
  std::uint64_t written = 0;
  file.read (end, reinterpret_cast<std::uint8_t*> (&written), sizeof written);
  return checksum.value () == written ? ResultState::COMPLETE : ResultState::DAMAGED;
}

ResultReader::ResultReader (const Plan& plan, std::size_t tile, std::size_t memory)
: path_ (plan.resultPath (tile))
, step_ (plan.result.bytes ())
, left_ (plan.tiles[tile].points)
, begin_ (sizeof (Header))
, at_once_ (std::max<std::size_t> (memory / step_, 1))
{}

const std::uint8_t*
ResultReader::peek ()
{
  if (at_ == buffer_.size () && left_ > 0)
    refill ();
  return at_ < buffer_.size () ? &buffer_[at_] : nullptr;
}

void
ResultReader::refill ()
{
  RandomAccessFile file; // opened each time: there may be more tiles than files that may be open
  file.open (path_, "run this tile again");
  const auto count = static_cast<std::size_t> (std::min<std::uint64_t> (at_once_, left_));
  buffer_.resize (count * step_);
  if (file.read (begin_, buffer_.data (), buffer_.size ()) < buffer_.size ())
    throw FileError (path_, "has become shorter", "run this tile again");
  begin_ += buffer_.size ();
  left_ -= count;
  at_ = 0;
}
} // namespace tools
} // namespace pcl_normal_smoothing
