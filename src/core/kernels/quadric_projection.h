// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "local_points.h"

namespace pcl_normal_smoothing
{
namespace core
{
namespace PCL_NORMAL_SMOOTHING_ISA
{
/** Moves each point onto a quadric fitted to its neighbourhood, along the normal of the plane over which it is
  * fitted; plane and quadric both have weights exp (-d^2 / h^2), h the distance of the farthest. A point stays if it
  * has too few neighbours, or the quadric passes outside the neighbourhood. */
LANES_INLINE void
projectPoints (const QuadricProjection& projection, const BlockRows& rows, int first)
{
  const std::uint32_t* own = rows.neighbors + first;
  const LocalPointsOf<max_projection_neighbors> local (projection.nodes, rows, own);
  Lanes weights[max_projection_neighbors];
  for (std::size_t j = 0; j < local.count; ++j)
    weights[j] = local.one[j] * bell (dot (local.at[j], local.at[j]));
  const Frame frame (planeNormal (local, weights));
  Quadric quadric;
  for (std::size_t j = 0; j < local.count; ++j)
    quadric.add (dot (local.at[j], frame.u), dot (local.at[j], frame.v), dot (local.at[j], frame.normal), weights[j]);
  quadric.solve (splat (0));
  const Lanes height = quadric.height (splat (0), splat (0));
  const Lanes3 offset = load3OrZero (projection.nodes.offset, own);
  const Mask valid = (local.size () >= min_fit_points) & (absolute (height) < 1.0f);
  store3 (projection.projected, own, choose (valid, offset + (height * local.reach) * frame.normal, offset));
}
} // namespace PCL_NORMAL_SMOOTHING_ISA
} // namespace core
} // namespace pcl_normal_smoothing
