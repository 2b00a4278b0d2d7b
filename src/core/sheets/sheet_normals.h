// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sheet_estimate.h"

namespace pcl_normal_smoothing
{
namespace core
{
/** The nodes among the first \a max_length entries of the rows of \a nodes, ascending. */
std::vector<std::uint32_t>
nodesInRows (const NeighborGraph& graph, const std::vector<std::uint32_t>& nodes, std::size_t max_length);

/** Normals that hold where another sheet is as close as the points: they are fitted to the eight nearest; then each
  * node takes, of those in its neighbourhood, the one that fits most of the points. Where the nearest are of both
  * sheets, many of the planes are wrong, but hardly all.
  * \param[in] by a point is weighted by a Gaussian of its height over the plane, with sigma half of by.distance
  * \param[in] nodes that get a normal; null: all */
Vectors
electNormals (const NeighborGraph& graph,
              const Positions& positions,
              const SheetScale& by,
              const std::vector<std::uint32_t>* nodes,
              const Execution& execution);

/** A second vote, in which the neighbours' normals count too: along the outline of two sheets, a plane across both fits
  * as many points as that of one sheet, but not their normals.
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
