// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cell_index.h"

#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

namespace pcl_normal_smoothing
{
namespace tools
{
struct Depth;

/** A node whose row may lack points, and how many hops a computation looks on from there. */
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
  /** As searched, and as used: other rows where sheets are separated. */
  const core::NeighborGraph& searched;
  const core::NeighborGraph& used;
  /** In the unit of the plan, in the order of the nodes. */
  const core::Positions& nodes;
  /** Of every point of the graphs' cloud. */
  const std::vector<std::uint32_t>& cell_of;
  const CellIndex& cells;

  std::uint32_t
  cellOf (std::uint32_t node) const
  {
    return cell_of[searched.order ()[node]];
  }

  /** Where a node is, in the unit of the files. */
  Eigen::Vector3d
  placeOf (std::uint32_t node) const;

  /** Within how far from a node other points could change its searched row, in the unit of the files, roundings
    * included; infinity where the row is short. */
  double
  rowRadius (std::uint32_t node) const;
};

/** Walks over the rows that a computation for the \a wanted nodes reads.
  * \return the nodes, in any order, whose searched row could be another if all points were there; empty: the
  * computation gives what it would give for the whole cloud */
std::vector<Doubt>
findDoubts (const Neighborhoods& neighborhoods,
            const std::vector<std::uint32_t>& wanted,
            const Depth& depth,
            const core::Execution& execution);
} // namespace tools
} // namespace pcl_normal_smoothing
