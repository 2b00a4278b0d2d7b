// SPDX-License-Identifier: BSD-3-Clause
#include "spill_file.h"

#include "files/signal_pause.h"
#include "files/tool_error.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

namespace pcl_normal_smoothing
{
namespace tools
{
SpillFile::SpillFile (const std::string& folder, std::size_t buckets, std::size_t memory)
: folder_ (folder)
, buffer_size_ (std::clamp<std::size_t> (memory / (buckets + 1), 1u << 12, 1u << 22))
, buckets_ (buckets)
{
  std::string name = folder + "/spill.XXXXXX";
  const SignalPause pause;
  descriptor_ = mkostemp (name.data (), O_CLOEXEC);
  if (descriptor_ < 0)
    fail ("a temporary file cannot be made in it");
  unlink (name.c_str ());
}

SpillFile::~SpillFile ()
{
  close (descriptor_);
}

void
SpillFile::add (std::size_t bucket, std::string_view bytes)
{
  buckets_[bucket].buffer += bytes;
  buckets_[bucket].size += bytes.size ();
  if (buckets_[bucket].buffer.size () >= buffer_size_)
    flush (buckets_[bucket]);
}

void
SpillFile::flush (Bucket& bucket)
{
  std::size_t done = 0;
  while (done < bucket.buffer.size ()) {
    const ssize_t written = pwrite (descriptor_, bucket.buffer.data () + done, bucket.buffer.size () - done,
                                    static_cast<off_t> (end_ + done));
    if (written < 0 && errno != EINTR)
      fail ("a temporary file cannot be written there");
    done += written > 0 ? static_cast<std::size_t> (written) : 0;
  }
  bucket.blocks.push_back ({end_, bucket.buffer.size ()});
  end_ += bucket.buffer.size ();
  bucket.buffer.clear ();
}

void
SpillFile::read (std::size_t number, const std::function<void (std::string_view)>& use)
{
  Bucket& bucket = buckets_[number];
  std::string bytes;
  for (const Block& block : bucket.blocks) {
    bytes.resize (block.size);
    for (std::size_t done = 0; done < block.size;) {
      const ssize_t got =
          pread (descriptor_, bytes.data () + done, block.size - done, static_cast<off_t> (block.begin + done));
      if (got == 0 || (got < 0 && errno != EINTR))
        fail ("a temporary file cannot be read there");
      done += got > 0 ? static_cast<std::size_t> (got) : 0;
    }
    use (bytes);
  }
  use (bucket.buffer);
}

void
SpillFile::fail (const char* action) const
{
  const bool full = errno == ENOSPC || errno == EDQUOT || errno == EFBIG;
  throw FileError (folder_, std::string (action) + " (" + std::strerror (errno) + ")",
                   full ? "free some space, or name a folder on another disk" : "name another folder");
}
} // namespace tools
} // namespace pcl_normal_smoothing
