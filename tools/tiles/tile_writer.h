// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan.h"

namespace pcl_normal_smoothing
{
namespace tools
{
/** A point of the sample from which the noise is estimated. */
struct SamplePoint
{
  std::uint32_t cell;
  std::uint64_t number;
  Eigen::Vector3d place;
};

/** Parts points in tiles and cells, writes the files of tiles, and notes them in the plan. */
class TileWriter
{
public:
  /** \param[in,out] plan complete but for tiles and cells; used as long as this lives
    * \param[in] max_points of a tile
    * \param[in] cell_points most of a cell
    * \param[in] sample_limit of the hashes of the points in the sample */
  TileWriter (Plan& plan,
              std::uint64_t max_points,
              std::size_t cell_points,
              std::uint32_t sample_limit,
              const core::Execution& execution);

  /** \param[in] records of plan.record, in the order of their numbers: one tile's, or those of several \throw
    * FileError */
  void
  add (const std::vector<std::uint8_t>& records);

  /** The points that are in the sample. */
  const std::vector<SamplePoint>&
  sample () const
  {
    return sample_;
  }

private:
  struct Point
  {
    Eigen::Vector3d place;
    std::uint32_t record;
  };

  struct Range
  {
    std::size_t begin, end;
  };

  /** Halves ranges until none has more than \a most points. */
  void
  split (Range range, std::size_t most, std::vector<Range>& parts);

  void
  writeTile (const std::vector<std::uint8_t>& records, Range tile);

  /** The cells of a tile, side by side. */
  std::vector<std::pair<Range, Cell>>
  makeCells (Range range);

  Cell
  makeCell (Range range);

  float
  reachOf (Range range, const Eigen::Vector3d& center) const;

  Plan& plan_;
  std::uint64_t max_points_;
  std::size_t cell_points_;
  std::uint32_t sample_limit_;
  const core::Execution& execution_;
  std::vector<Point> points_;
  std::vector<bool> in_sample_; // records
  std::vector<SamplePoint> sample_;
};
} // namespace tools
} // namespace pcl_normal_smoothing
