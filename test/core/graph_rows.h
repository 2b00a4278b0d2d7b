// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "neighbor_clouds.h"

#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

namespace test_support
{
/** The neighbours of one node, as indices in the cloud. */
inline IndexRow
rowInCloud (const pcl_normal_smoothing::core::NeighborGraph& graph, std::size_t node)
{
  const auto row = graph.row (node);
  IndexRow result;
  for (std::size_t j = 0; j < row.size (); ++j)
    result.push_back (graph.order ()[row[j]]);
  return result;
}

/** All rows by point, in the order of the cloud; empty for points without a node. */
inline std::vector<IndexRow>
rowsByPoint (const pcl_normal_smoothing::core::NeighborGraph& graph)
{
  std::vector<IndexRow> rows (graph.cloudSize ());
  for (std::size_t node = 0; node < graph.size (); ++node)
    rows[graph.order ()[node]] = rowInCloud (graph, node);
  return rows;
}

/** Reorders values from the order of the nodes to that of the cloud. */
inline Vectors
byPoint (const Vectors& of_nodes, const pcl_normal_smoothing::core::NeighborGraph& graph)
{
  Vectors of_points (graph.cloudSize (), Eigen::Vector3f::Constant (std::numeric_limits<float>::quiet_NaN ()));
  for (std::size_t node = 0; node < of_nodes.size (); ++node)
    of_points[graph.order ()[node]] = of_nodes[node];
  return of_points;
}

/** Reorders values from the order of the cloud to that of the nodes. */
inline Vectors
byNode (const Vectors& of_points, const pcl_normal_smoothing::core::NeighborGraph& graph)
{
  Vectors of_nodes;
  for (const std::uint32_t i : graph.order ())
    of_nodes.push_back (of_points[i]);
  return of_nodes;
}
} // namespace test_support
