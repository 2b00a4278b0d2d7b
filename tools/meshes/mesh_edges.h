// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh_io.h"

namespace pcl_normal_smoothing
{
namespace tools
{
/** An edge of a closed mesh: the triangle on its left has the corners in the order a, b, the one on its right b, a. */
struct MeshEdge
{
  std::uint32_t a, b;
  std::uint32_t left, right;
};

/** The edges that have exactly two triangles, one on each side. */
std::vector<MeshEdge>
edgesOf (const Mesh& mesh);

/** Splits up to \a count of the longest edges in the middle, at most one per triangle; each split adds one vertex. */
void
splitLongestEdges (std::size_t count, Mesh& mesh);

/** Flips the edges for which the angles opposite them, in the two triangles, add up to more than 180 degrees.
  * \return how many were flipped */
std::size_t
flipEdges (Mesh& mesh);
} // namespace tools
} // namespace pcl_normal_smoothing
