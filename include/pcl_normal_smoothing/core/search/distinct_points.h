// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/parallel_for.h>
#include <pcl_normal_smoothing/core/positions.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** Points exactly in the place of another one, as when overlapping files were joined, or a mesh was written triangle
  * by triangle. As neighbours they would take the places of other points, and quadrics would find no noise between
  * them. */
struct Copies
{
  Elements points;
  /** For each of \a points the first point in its place, or the node of that. */
  Elements originals;
};

/** Separates the first point in every place from its copies.
  * \param[in] cloud in which all \a points are finite
  * \param[in,out] points ascending; on return without copies
  * \return the copies, in no particular order */
Copies
takeOutCopies (const Positions& cloud, const Execution& execution, Elements& points);
} // namespace core
} // namespace pcl_normal_smoothing
