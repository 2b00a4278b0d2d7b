// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/kernels.h>
#include <pcl_normal_smoothing/core/neighbor_graph.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** Calls \a body for all blocks of nodes, from all threads. */
template <typename Body>
void
forEachBlock (const NeighborGraph& graph, const Execution& execution, const Body& body)
{
  parallelFor (
      graph.blockCount (), execution,
      [&] (std::size_t begin, std::size_t end) {
        for (std::size_t block = begin; block < end; ++block)
          body (BlockRows {graph.blockRows (block), graph.blockLength (block), graph.blockBegin (block)});
      },
      64);
}

inline NodeArrays
nodeArrays (const Positions& positions, const Vectors& normals)
{
  return {positions.base.data ()->data (), positions.offset.data ()->data (), normals.data ()->data ()};
}
} // namespace core
} // namespace pcl_normal_smoothing
