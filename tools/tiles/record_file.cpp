// SPDX-License-Identifier: BSD-3-Clause
#include "record_file.h"

#include "files/checksum.h"
#include "files/tool_error.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

namespace pcl_normal_smoothing
{
namespace tools
{
RandomAccessFile::~RandomAccessFile ()
{
  if (descriptor_ >= 0)
    close (descriptor_);
}

void
RandomAccessFile::open (const std::string& path, const std::string& advice)
{
  if (descriptor_ >= 0)
    close (descriptor_);
  path_ = path;
  descriptor_ = ::open (path.c_str (), O_RDONLY | O_CLOEXEC);
  if (descriptor_ < 0)
    throw FileError (path, "cannot be read (" + std::string (std::strerror (errno)) + ")", advice);
}

std::size_t
RandomAccessFile::read (std::uint64_t begin, std::uint8_t* bytes, std::size_t count) const
{
  std::size_t done = 0;
  while (done < count) {
    const ssize_t got = pread (descriptor_, bytes + done, count - done, static_cast<off_t> (begin + done));
    if (got < 0 && errno != EINTR)
      throw FileError (path_, "cannot be read (" + std::string (std::strerror (errno)) + ")", "see to the disk");
    if (got == 0)
      break;
    done += got > 0 ? static_cast<std::size_t> (got) : 0;
  }
  return done;
}

std::uint64_t
RandomAccessFile::size () const
{
  struct stat status;
  return fstat (descriptor_, &status) == 0 ? static_cast<std::uint64_t> (status.st_size) : 0;
}

void
RecordReader::read (std::uint32_t number, std::vector<std::uint8_t>& records)
{
  const std::string advice = "run plan again";
  const Cell& cell = plan_.cells[number];
  if (file_.path ().empty () || cell.tile != tile_)
    file_.open (plan_.pointsPath (cell.tile), advice);
  tile_ = cell.tile;
  const std::size_t begin = records.size (), bytes = cell.points * plan_.record.bytes ();
  records.resize (begin + bytes);
  if (file_.read (cell.begin, records.data () + begin, bytes) < bytes)
    throw FileError (file_.path (), "is truncated", advice);
  if (checksumOf ({reinterpret_cast<const char*> (records.data () + begin), bytes}) != cell.checksum)
    throw FileError (file_.path (), "is damaged, a checksum differs", advice);
}
} // namespace tools
} // namespace pcl_normal_smoothing
