// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record_file.h"

namespace pcl_normal_smoothing
{
namespace tools
{
/** How the result of a tile stands. */
enum class ResultState
{
  MISSING,
  DAMAGED, //!< or of another plan
  COMPLETE
};

/** Writes the result of a tile: it is there once it is complete.
  * \param[in] records of plan.result, ascending by their numbers
  * \param[in] with_normal how many of the points had a normal to begin with \throw FileError */
void
saveResult (const Plan& plan, std::size_t tile, const std::vector<std::uint8_t>& records, std::uint64_t with_normal);

/** Reads all of it.
  * \param[out] with_normal as given to saveResult, where the result is complete */
ResultState
checkResult (const Plan& plan, std::size_t tile, std::uint64_t& with_normal);

/** Reads a result that is complete, record by record. */
class ResultReader
{
public:
  /** \param[in] memory bytes of its buffer */
  ResultReader (const Plan& plan, std::size_t tile, std::size_t memory);

  /** The next record; nullptr behind the last. \throw FileError */
  const std::uint8_t*
  peek ();

  void
  skip ()
  {
    at_ += step_;
  }

private:
  void
  refill ();

  std::string path_;
  std::size_t step_;
  std::uint64_t left_;  // records that are not in the buffer yet
  std::uint64_t begin_; // of those, in the file
  std::size_t at_once_; // records
  std::vector<std::uint8_t> buffer_;
  std::size_t at_ = 0;
};
} // namespace tools
} // namespace pcl_normal_smoothing
