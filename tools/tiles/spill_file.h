// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record_file.h"

#include <functional>
#include <string_view>

namespace pcl_normal_smoothing
{
namespace tools
{
/** Buckets of bytes that are filled at the same time and do not fit into memory. They are kept in one file that has no
  * name and disappears with the process, however that ends. */
class SpillFile
{
public:
  /** \param[in] folder where there is room for the file
    * \param[in] memory bytes of all buffers together \throw FileError */
  SpillFile (const std::string& folder, std::size_t buckets, std::size_t memory);
  ~SpillFile ();

  SpillFile (const SpillFile&) = delete;
  SpillFile&
  operator= (const SpillFile&) = delete;

  /** \throw FileError if the disk is full */
  void
  add (std::size_t bucket, std::string_view bytes);

  std::uint64_t
  size (std::size_t bucket) const
  {
    return buckets_[bucket].size;
  }

  /** Calls \a use with what was added to a bucket, in order, in pieces that do not split what one add () added. */
  void
  read (std::size_t bucket, const std::function<void (std::string_view)>& use);

private:
  struct Block
  {
    std::uint64_t begin;
    std::size_t size;
  };

  struct Bucket
  {
    std::string buffer;
    std::vector<Block> blocks;
    std::uint64_t size = 0;
  };

  void
  flush (Bucket& bucket);

  [[noreturn]] void
  fail (const char* action) const;

  std::string folder_;
  int descriptor_ = -1;
  std::uint64_t end_ = 0;
  std::size_t buffer_size_;
  std::vector<Bucket> buckets_;
};
} // namespace tools
} // namespace pcl_normal_smoothing
