// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/parallel_for.h>
#include <pcl_normal_smoothing/core/positions.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** Moves points that left their rays back onto them: to where the ray from the origin meets the tangent plane that the
  * point has reached. This keeps the grid of a depth camera; otherwise the points of a slanting wall slide towards the
  * middle of their layer and leave gaps between layers. A point that would end farther than \a max_displacement from
  * its start, or whose ray grazes its plane, is left where the rounds put it.
  * \param[in] start offsets before anything moved, as returned by startOf
  * \param[in] normals of unit length; points without one (NaN) stay
  * \param[in,out] positions their offsets change */
void
moveAlongRays (const Vectors& start,
               const Vectors& normals,
               float max_displacement,
               const Execution& execution,
               Positions& positions);
} // namespace core
} // namespace pcl_normal_smoothing
