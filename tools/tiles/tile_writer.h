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

/** Divides points into tiles and cells, writes the files of the tiles, and enters them in the plan. */
class TileWriter
{
public:
  /** \param[in,out] plan complete except for tiles and cells; must outlive this object
    * \param[in] max_points limit per tile
    * \param[in] cell_points limit per cell
    * \param[in] sample_limit limit on the hashes of the points in the sample */
  TileWriter (Plan& plan,
              std::uint64_t max_points,
              std::size_t cell_points,
              std::uint32_t sample_limit,
              const core::Execution& execution);

  /** \param[in] records in the layout plan.record, in the order of their numbers, of one or several tiles
    * \throw FileError */
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

  /** Makes the cells of a tile, in parallel. */
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
  std::vector<bool> in_sample_; // per record
  std::vector<SamplePoint> sample_;
};
} // namespace tools
} // namespace pcl_normal_smoothing
