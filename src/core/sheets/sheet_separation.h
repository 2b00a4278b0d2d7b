// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** What tells that a neighbour lies on another sheet of the surface: the two sides of a thin plate, two leaves. */
struct SheetSeparationOptions
{
  /** How far a neighbour must lie from the tangent plane, in the unit of the positions; the mean of both points'
    * planes, which a curved sheet touches. infinity: all points lie on one sheet. */
  float distance = std::numeric_limits<float>::infinity ();
  /** Normals that point to the same side everywhere: a neighbour with an opposite one lies on another sheet. */
  const Vectors* oriented_normals = nullptr;
};

/** How far along the rows of a graph separateSheets looks: the new row of a node depends on the rows of nodes that are
  * up to so many hops off, and on the points in them. -1 where it changes none. */
int
separationDepth (const SheetSeparationOptions& options);

/** Neighbourhoods that keep to one sheet. A node three of whose neighbours lie on another sheet, or one in a row of at
  * most 16 points, takes in their place the nearest points of its own among the neighbours of its neighbours; heights
  * count from where most of these lie. Normals are those of the eight nearest, each node then taking the one of its
  * neighbourhood that most of the points fit: where two sheets are as close as the points, many a plane fitted to the
  * nearest of both is wrong, but hardly all. Of every row the first 32 points count.
  * \return \a graph itself where nothing changes; else one whose changed rows hold at most 32 points */
NeighborGraph::ConstPtr
separateSheets (const NeighborGraph::ConstPtr& graph,
                const Positions& positions,
                const SheetSeparationOptions& options,
                const Execution& execution);
} // namespace core
} // namespace pcl_normal_smoothing
