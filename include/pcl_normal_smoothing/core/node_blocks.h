// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/kernels.h>
#include <pcl_normal_smoothing/core/neighbor_graph.h>

#include <algorithm>

namespace pcl_normal_smoothing
{
namespace core
{
/** Where a block begins in an array that has one byte for two neighbours; for block = blockCount () its size. */
inline std::size_t
pairsBegin (const NeighborGraph& graph, std::size_t block)
{
  return (graph.blockBegin (block) + NeighborGraph::block_size * block) / 2; // an odd neighbour has a byte of its own
}

/** Calls \a body for all blocks of nodes, from all threads. */
template <typename Body>
void
forEachBlock (const NeighborGraph& graph, const Execution& execution, const Body& body)
{
  parallelFor (
      graph.blockCount (), execution,
      [&] (std::size_t begin, std::size_t end) {
        for (std::size_t block = begin; block < end; ++block)
          body (BlockRows {graph.blockRows (block), graph.blockLength (block), graph.blockBegin (block),
                           pairsBegin (graph, block)});
      },
      64);
}

inline NodeArrays
nodeArrays (const Positions& positions, const Vectors& normals)
{
  const float* offset = hasOffsets (positions) ? positions.offset.data ()->data () : nullptr;
  return {positions.base.data ()->data (), offset, normals.data ()->data ()};
}
/** Whether no node is without a normal. */
inline bool
haveAllNormals (const Vectors& normals)
{
  return std::none_of (normals.begin (), normals.end (),
                       [] (const Eigen::Vector3f& normal) { return normal.x () != normal.x (); });
}
} // namespace core
} // namespace pcl_normal_smoothing
