// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cell_index.h"

#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

namespace pcl_normal_smoothing
{
namespace tools
{
struct Depth;

/** A node whose row may lack points, and how many hops a computation goes on from there. */
struct Doubt
{
  std::uint32_t node;
  int hops_left;
};

/** Neighbourhoods among the points of some cells of a plan. */
struct Neighborhoods
{
  const Plan& plan;
  core::NeighborQuery query; // in the unit of the plan
  /** As searched, and as used: they differ if sheets are separated. */
  const core::NeighborGraph& searched;
  const core::NeighborGraph& used;
  /** In the unit of the plan, in the order of the nodes. */
  const core::Positions& nodes;
  /** The cell of every point of the graphs' cloud. */
  const std::vector<std::uint32_t>& cell_of;
  const CellIndex& cells;

  std::uint32_t
  cellOf (std::uint32_t node) const
  {
    return cell_of[searched.order ()[node]];
  }

  /** The position of a node, in the unit of the files. */
  Eigen::Vector3d
  placeOf (std::uint32_t node) const;

  /** The distance from a node within which other points could change its searched row, in the unit of the files, with a
    * margin for rounding; the radius of the query, which may be infinite, if it has no k or the row is shorter. */
  double
  rowRadius (std::uint32_t node) const;
};

/** Visits the rows that a computation for the \a wanted nodes reads.
  * \return the nodes, in any order, whose searched row might differ if all points were loaded; empty: the computation
  * gives the same as for the whole cloud */
std::vector<Doubt>
findDoubts (const Neighborhoods& neighborhoods,
            const std::vector<std::uint32_t>& wanted,
            const Depth& depth,
            const core::Execution& execution);
} // namespace tools
} // namespace pcl_normal_smoothing
