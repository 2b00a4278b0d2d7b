// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shapes.h"

#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

namespace test_support
{
/** A cloud with its neighbourhoods. */
struct Searched
{
  explicit Searched (const Vectors& points, const pcl_normal_smoothing::core::NeighborQuery& query = {32})
  : graph (pcl_normal_smoothing::core::NeighborGraph::build (asPositions (points),
                                                             query,
                                                             pcl_normal_smoothing::core::Execution (2)))
  , nodes (gather (asPositions (points), graph->order ()))
  {}

  pcl_normal_smoothing::core::NeighborGraph::ConstPtr graph;
  Positions nodes;
};
} // namespace test_support
