// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh_io.h"

namespace pcl_normal_smoothing
{
namespace tools
{
/** An edge of a closed mesh: the triangle at its left has its corners in the order a, b; that at its right b, a. */
struct MeshEdge
{
  std::uint32_t a, b;
  std::uint32_t left, right;
};

/** The edges that have exactly two triangles, one at each side. */
std::vector<MeshEdge>
edgesOf (const Mesh& mesh);

/** Splits up to \a count of the longest edges in their middle; each makes one vertex. */
void
splitLongestEdges (std::size_t count, Mesh& mesh);

/** Swaps the diagonals of pairs of triangles whose angles opposite of their edge are more than 180 degrees together.
  * \return how many were swapped */
std::size_t
flipEdges (Mesh& mesh);
} // namespace tools
} // namespace pcl_normal_smoothing
