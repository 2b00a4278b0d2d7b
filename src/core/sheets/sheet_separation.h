// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** The criterion for a neighbour on another sheet of the surface, such as the other side of a thin plate. */
struct SheetSeparationOptions
{
  /** A neighbour on another sheet is at least this far off the mean of both tangent planes, which touches a curved
    * sheet; in the unit of the positions. infinity: all points lie on one sheet. */
  float distance = std::numeric_limits<float>::infinity ();
  /** Consistently oriented normals: a neighbour with an opposite one lies on another sheet. */
  const Vectors* oriented_normals = nullptr;
};

/** Depth of separateSheets in hops along the rows: the new row of a node depends on the rows of nodes up to that
  * many hops away, and on the points in them. -1 if no row changes. */
int
separationDepth (const SheetSeparationOptions& options);

/** Neighbourhoods restricted to one sheet. If three neighbours of a node lie on another sheet (one in a row of at most
  * 16 points), they are replaced by the nearest points of its own sheet among the neighbours of its neighbours; heights
  * count from where most of the neighbours lie. Normals are fitted to the eight nearest; then each node takes, of those
  * in its neighbourhood, the one that fits most of the points: where two sheets are as close as the points, many planes
  * are wrong, but hardly all. Of every row the first 32 points count.
  * \return \a graph itself if nothing changes; else one whose changed rows hold at most 32 points */
NeighborGraph::ConstPtr
separateSheets (const NeighborGraph::ConstPtr& graph,
                const Positions& positions,
                const SheetSeparationOptions& options,
                const Execution& execution);
} // namespace core
} // namespace pcl_normal_smoothing
