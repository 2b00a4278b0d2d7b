// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/parallel_for.h>
#include <pcl_normal_smoothing/core/positions.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** Points that lie exactly where another one lies: where files were joined that overlap, or a mesh was written triangle
  * by triangle. Among the neighbours of a point they would take the places of others, and quadrics would find no noise
  * between them. */
struct Copies
{
  Elements points;
  /** For every one of \a points the first point in its place, or the node of that. */
  Elements originals;
};

/** Parts the first point in every place from its copies.
  * \param[in] cloud in which all \a points are finite
  * \param[in,out] points ascending; on return without copies
  * \return in no order that means anything */
Copies
takeOutCopies (const Positions& cloud, const Execution& execution, Elements& points);
} // namespace core
} // namespace pcl_normal_smoothing
