// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan.h"

#include <functional>

namespace pcl_normal_smoothing
{
namespace tools
{
/** Finds the cells near a place that are not loaded yet. */
class CellIndex
{
public:
  /** \param[in] cells of a plan; fastest if neighbours in space follow each other */
  explicit CellIndex (const std::vector<Cell>& cells);

  bool
  isLoaded (std::size_t cell) const
  {
    return loaded_[leaves_ - 1 + cell] != 0;
  }

  bool
  allLoaded () const
  {
    return loaded_.front () != 0;
  }

  void
  setLoaded (std::size_t cell);

  /** Whether a cell that is not loaded may have a point within a distance of a place. */
  bool
  isNear (const Eigen::Vector3d& place, double distance) const;

  /** Distance from a box to the nearest cell that is not loaded; infinity if all are. */
  double
  distanceFrom (const Eigen::AlignedBox3d& box) const;

  using Use = std::function<void (std::uint32_t cell, double distance)>;

  /** Calls \a use for the cells that are not loaded and lie within a distance of a box. */
  void
  forEachNear (const Eigen::AlignedBox3d& box, double distance, const Use& use) const;

private:
  std::size_t leaves_ = 1; // the leaves are the last nodes; the children of node i are 2i + 1 and 2i + 2
  std::vector<Eigen::AlignedBox3d> boxes_;
  std::vector<std::uint8_t> loaded_; // whether all cells below a node are
};
} // namespace tools
} // namespace pcl_normal_smoothing
