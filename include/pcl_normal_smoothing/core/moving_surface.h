// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/positions.h>

#include <utility>

namespace pcl_normal_smoothing
{
namespace core
{
/** The nodes of a cloud while they move. */
struct MovingSurface
{
  /** \param[in] their_normals where they are not to be estimated */
  explicit MovingSurface (Positions nodes, Vectors their_normals = {})
  : positions (std::move (nodes)), normals (std::move (their_normals)), start (startOf (positions))
  {}

  /** How far the nodes have moved. */
  Vectors
  displacements () const
  {
    return core::displacements (start, positions);
  }

  /** Only the offsets change. */
  Positions positions;
  /** Length 1, or NaN: none. */
  Vectors normals;
  /** Where the nodes began, as startOf tells it. A limit of displacements counts from here. */
  Vectors start;
};
} // namespace core
} // namespace pcl_normal_smoothing
