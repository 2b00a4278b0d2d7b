// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record_file.h"

namespace pcl_normal_smoothing
{
namespace tools
{
/** State of the result of a tile. */
enum class ResultState
{
  MISSING,
  DAMAGED, //!< or from another plan
  COMPLETE
};

/** Writes the result of a tile; the file appears once it is complete.
  * \param[in] records in the layout plan.result, in ascending order of their numbers
  * \param[in] with_normal how many of the points had a normal to begin with \throw FileError */
void
saveResult (const Plan& plan, std::size_t tile, const std::vector<std::uint8_t>& records, std::uint64_t with_normal);

/** Reads and checks all of a result.
  * \param[out] with_normal as given to saveResult, if the result is complete */
ResultState
checkResult (const Plan& plan, std::size_t tile, std::uint64_t& with_normal);

/** Reads a result that is complete, record by record. */
class ResultReader
{
public:
  /** \param[in] memory bytes of its buffer */
  ResultReader (const Plan& plan, std::size_t tile, std::size_t memory);

  /** The next record; nullptr after the last. \throw FileError */
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
  std::uint64_t begin_; // where these begin in the file
  std::size_t at_once_; // records per refill
  std::vector<std::uint8_t> buffer_;
  std::size_t at_ = 0;
};
} // namespace tools
} // namespace pcl_normal_smoothing
