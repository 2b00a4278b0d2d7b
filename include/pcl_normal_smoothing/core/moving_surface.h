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
  /** \param[in] their_normals if these are not to be estimated */
  explicit MovingSurface (Positions nodes, Vectors their_normals = {})
  : positions (std::move (nodes)), normals (std::move (their_normals)), start (startOf (positions))
  {}

  /** The displacements of the nodes so far. */
  Vectors
  displacements () const
  {
    return core::displacements (start, positions);
  }

  /** Only the offsets change. */
  Positions positions;
  /** Unit length; NaN: none. */
  Vectors normals;
  /** Initial offsets of the nodes, as returned by startOf. The maximal displacement counts from here. */
  Vectors start;
};
} // namespace core
} // namespace pcl_normal_smoothing
