// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/parallel_for.h>
#include <pcl_normal_smoothing/core/positions.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** Gives points that have moved across their tangent planes the place on these where their rays from the origin meet
  * them. So the grid of a depth camera is kept; otherwise the points of a slanting wall slide towards the middle of
  * their layer, and gaps are left between the layers. Points stay that would be farther than \a max_displacement from
  * where they began, or whose rays graze their planes.
  * \param[in] start offsets before anything moved, as startOf tells
  * \param[in] normals of length 1; points without (NaN) stay
  * \param[in,out] positions their offsets change */
void
moveAlongRays (const Vectors& start,
               const Vectors& normals,
               float max_displacement,
               const Execution& execution,
               Positions& positions);
} // namespace core
} // namespace pcl_normal_smoothing
