// SPDX-License-Identifier: BSD-3-Clause
#include "byte_stream.h"

#include "checksum.h"
#include "field_values.h"
#include "tool_error.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
constexpr std::size_t buffer_size = 1u << 20;
constexpr std::string_view space = " \t\r\n\v\f";

[[noreturn]] void
failToRead (const std::string& path, const std::string& reason)
{
  throw FileError (path, "cannot be read (" + reason + ")", "name a file that exists and that you may read");
}
} // namespace

ByteStream::ByteStream (std::string_view bytes) : ahead_ (bytes), left_ (bytes.size ()) {}

ByteStream::ByteStream (const std::filesystem::path& path) : path_ (path), checksum_ (std::make_unique<Checksum> ())
{
  struct stat status;
  if (stat (path_.c_str (), &status) != 0)
    failToRead (path_, std::strerror (errno));
  if (S_ISDIR (status.st_mode))
    throw FileError (path_, "is a folder", "give the files in it");
  if (!S_ISREG (status.st_mode)) // before open, which would wait for a pipe
    failToRead (path_, "it is no regular file, and is read more than once");
  descriptor_ = open (path_.c_str (), O_RDONLY | O_CLOEXEC);
  if (descriptor_ < 0)
    failToRead (path_, std::strerror (errno));
  left_ = static_cast<std::uint64_t> (status.st_size);
}

ByteStream::~ByteStream ()
{
  if (descriptor_ >= 0)
    close (descriptor_);
}

void
ByteStream::refill (std::size_t least)
{
  std::size_t size = ahead_.size ();
  std::string bytes (std::max (least, buffer_size), '\0');
  std::copy (ahead_.begin (), ahead_.end (), bytes.begin ());
  buffer_.swap (bytes);
  ssize_t count = 1;
  while (size < buffer_.size () && count != 0) {
    count = read (descriptor_, buffer_.data () + size, buffer_.size () - size);
    if (count < 0 && errno != EINTR)
      failToRead (path_, std::strerror (errno));
    if (count > 0)
      checksum_->add ({buffer_.data () + size, static_cast<std::size_t> (count)});
    size += count > 0 ? static_cast<std::size_t> (count) : 0;
  }
  ahead_ = std::string_view (buffer_).substr (0, std::min<std::uint64_t> (size, left_));
  if (count == 0) // the file may have become shorter
    left_ = ahead_.size ();
}

std::string
ByteStream::checksum () const
{
  return checksum_->text ();
}

std::string_view
nextWord (ByteStream& stream)
{
  std::size_t least = 256;
  std::size_t begin = stream.peek (least).find_first_not_of (space);
  while (begin == std::string_view::npos && stream.left () > 0) {
    stream.skip (stream.peek ().size ());
    begin = stream.peek (least).find_first_not_of (space);
  }
  stream.skip (begin);
  std::string_view text = stream.peek (least);
  while (text.find_first_of (space) == std::string_view::npos && text.size () < stream.left ())
    text = stream.peek (least *= 2);
  const std::string_view word = text.substr (0, text.find_first_of (space));
  stream.skip (word.size ());
  return word;
}

std::string_view
nextLine (ByteStream& stream)
{
  std::size_t least = 4096;
  std::string_view text = stream.peek (least);
  while (text.find ('\n') == std::string_view::npos && text.size () < stream.left ())
    text = stream.peek (least *= 2);
  std::string_view line = nextLine (text);
  stream.skip (static_cast<std::size_t> (text.data () - stream.peek (0).data ()));
  return line;
}
} // namespace tools
} // namespace pcl_normal_smoothing
