// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../kernels.h"
#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

#include <algorithm>

namespace pcl_normal_smoothing
{
namespace core
{
/** Begin of a block in an array with one byte per pair of neighbours; for block = blockCount () the array's size. */
inline std::size_t
pairsBegin (const NeighborGraph& graph, std::size_t block)
{
  return (graph.blockBegin (block) + block_size * block) / 2; // an odd last neighbour takes a whole byte
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

/** The same for some nodes only, combined into blocks in the given order.
  * \param[in] max_length rows are cut to this length */
template <typename Body>
void
forEachBlockOf (const NeighborGraph& graph,
                const std::vector<std::uint32_t>& nodes,
                std::size_t max_length,
                const Execution& execution,
                const Body& body)
{
  const auto gather = [&] (std::size_t block, std::vector<std::uint32_t>& neighbors) {
    std::size_t length = 0;
    for (std::size_t lane = 0; lane < block_size; ++lane) {
      const std::uint32_t node = nodes[std::min (block * block_size + lane, nodes.size () - 1)];
      const Row row = graph.row (node);
      for (std::size_t j = 0; j < max_length; ++j)
        neighbors[j * block_size + lane] = j < row.size () ? row[j] : node;
      length = std::max (length, std::min (row.size (), max_length));
    }
    return length;
  };
  parallelFor ((nodes.size () + block_size - 1) / block_size, execution,
               [&] (std::size_t begin, std::size_t end) {
                 std::vector<std::uint32_t> neighbors (max_length * block_size);
                 for (std::size_t block = begin; block < end; ++block) {
                   const std::size_t length = gather (block, neighbors);
                   body (BlockRows {neighbors.data (), length});
                 }
               },
               8);
}

/** The same for some nodes or for all.
  * \param[in] nodes null: all, in the blocks of the graph */
template <typename Body>
void
forEachBlockOf (const NeighborGraph& graph,
                const std::vector<std::uint32_t>* nodes,
                std::size_t max_length,
                const Execution& execution,
                const Body& body)
{
  if (nodes != nullptr)
    forEachBlockOf (graph, *nodes, max_length, execution, body);
  else
    forEachBlock (graph, execution, [&] (const BlockRows& rows) {
      body (BlockRows {rows.neighbors, std::min (rows.length, max_length)});
    });
}

/** For kernels that read no normals. Checks whether all offsets are zero: O(n) if they are. */
inline NodeArrays
nodeArrays (const Positions& positions)
{
  const float* offset = hasOffsets (positions) ? positions.offset.data ()->data () : nullptr;
  return {positions.base.data ()->data (), offset, nullptr};
}

/** The same with normals. */
inline NodeArrays
nodeArrays (const Positions& positions, const Vectors& normals)
{
  NodeArrays nodes = nodeArrays (positions);
  nodes.normals = normals.data ()->data ();
  return nodes;
}

/** Whether every node has a normal. */
inline bool
haveAllNormals (const Vectors& normals)
{
  return std::none_of (normals.begin (), normals.end (),
                       [] (const Eigen::Vector3f& normal) { return normal.x () != normal.x (); });
}
} // namespace core
} // namespace pcl_normal_smoothing
