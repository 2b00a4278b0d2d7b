// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sheet_estimate.h"

namespace pcl_normal_smoothing
{
namespace core
{
/** The nodes in the first \a max_length of the rows of \a nodes, ascending. */
std::vector<std::uint32_t>
nodesInRows (const NeighborGraph& graph, const std::vector<std::uint32_t>& nodes, std::size_t max_length);

/** Normals that hold where another sheet of the surface is as close as the points: those of the eight nearest, each
  * node then taking the one of its neighbourhood that most of the points fit. Many a plane fitted to the nearest of
  * both sheets is wrong, but hardly all.
  * \param[in] by a point counts by a Gaussian of its height over the plane, of half of the distance
  * \param[in] nodes that get one; null: all */
Vectors
electNormals (const NeighborGraph& graph,
              const Positions& positions,
              const SheetScale& by,
              const std::vector<std::uint32_t>* nodes,
              const Execution& execution);

/** A second vote, in which the normals around count too: along the outline of two sheets a plane across both has as
  * many points as that of one, but not their normals.
  * \param[in] normals of the first vote
  * \param[in] nodes that vote again */
Vectors
electAgain (const NeighborGraph& graph,
            const Positions& positions,
            float distance,
            const Vectors& normals,
            const std::vector<std::uint32_t>& nodes,
            const Execution& execution);
} // namespace core
} // namespace pcl_normal_smoothing
