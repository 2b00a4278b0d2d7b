// SPDX-License-Identifier: BSD-3-Clause
#include "searched.h"

#include <core/rounds/far_rows.h>
#include <core/search/node_blocks.h>

#include <gtest/gtest.h>

namespace
{
using namespace pcl_normal_smoothing::core;
using namespace test_support;

/** The far row of a node. */
std::vector<std::uint32_t>
farRow (const NeighborGraph& graph, const FarRows& rows, std::size_t node)
{
  const std::size_t block = node / block_size, lane = node % block_size;
  FarRows::Buffer buffer;
  const BlockRows far = rows.ofBlock ({graph.blockRows (block), graph.blockLength (block)}, buffer);
  std::vector<std::uint32_t> row;
  for (std::size_t slot = 0; slot < far.length; ++slot)
    row.push_back (far.neighbors[slot * block_size + lane]);
  return row;
}

/** Mean distance of a row's points from the node. */
double
reachOf (const Positions& nodes, std::uint32_t node, const std::vector<std::uint32_t>& row)
{
  double sum = 0;
  for (const std::uint32_t neighbor : row)
    sum += (nodes.base[neighbor] - nodes.base[node]).norm ();
  return sum / static_cast<double> (row.size () - 1);
}

TEST (FarRowsTest, ReachTwiceAsFar)
{
  for (const std::uint32_t k : {16u, 32u}) {
    const Searched cloud (withNoise (planeGrid (40, 1).points, 0.1, 1), {k});
    const FarRows rows (*cloud.graph, nodeArrays (cloud.nodes), Execution (2));
    double near = 0, far = 0;
    for (std::uint32_t node = 0; node < cloud.graph->size (); ++node) {
      const Eigen::Vector3f from_middle = cloud.nodes.base[node] - Eigen::Vector3f (19.5f, 19.5f, 0);
      if (from_middle.head<2> ().cwiseAbs ().maxCoeff () > 12) // near the border, there are no points farther out
        continue;
      const Row row = cloud.graph->row (node);
      std::vector<std::uint32_t> all;
      for (std::size_t j = 0; j < row.size (); ++j)
        all.push_back (row[j]);
      near += reachOf (cloud.nodes, node, all);
      far += reachOf (cloud.nodes, node, farRow (*cloud.graph, rows, node));
    }
    EXPECT_NEAR (far / near, 2, 0.15) << k;
  }
}

TEST (FarRowsTest, TheNodeIsNoNeighbourOfItself)
{
  const Searched cloud (withNoise (planeGrid (20, 1).points, 0.3, 2), {16});
  const FarRows rows (*cloud.graph, nodeArrays (cloud.nodes), Execution (2));
  for (std::uint32_t node = 0; node < cloud.graph->size (); ++node) {
    const std::vector<std::uint32_t> row = farRow (*cloud.graph, rows, node);
    EXPECT_EQ (row[0], node);
    for (std::size_t slot = 1; slot < row.size (); ++slot)
      EXPECT_NE (row[slot], node);
  }
}

TEST (FarRowsTest, ShortRowsEndWithTheNode)
{
  for (const std::uint32_t k : {1u, 2u, 5u}) {
    const Searched cloud (withNoise (planeGrid (10, 1).points, 0.1, 3), {k});
    const FarRows rows (*cloud.graph, nodeArrays (cloud.nodes), Execution (1));
    const std::vector<std::uint32_t> row = farRow (*cloud.graph, rows, 7);
    for (std::size_t slot = 0; slot < row.size (); ++slot)
      EXPECT_EQ (row[slot] == 7, slot == 0 || slot >= k) << k << " " << slot;
  }
}

TEST (FarRowsTest, WhatIsInNoRowDoesNotComeIn)
{
  // Two squares, each with rows of its own, like separated sheets.
  const Vectors points = parallelSheets (20, 1, 1).points;
  const auto ofOwnSheet = [&] (std::uint32_t index, std::vector<std::uint32_t>& neighbors) {
    neighbors.clear ();
    for (std::uint32_t i = 0; i < points.size (); ++i)
      if (points[i].z () == points[index].z () && (points[i] - points[index]).norm () < 2.5f)
        neighbors.push_back (i);
  };
  const auto graph = NeighborGraph::build (asPositions (points), ofOwnSheet, Execution (1));
  const Positions nodes = gather (asPositions (points), graph->order ());
  const FarRows rows (*graph, nodeArrays (nodes), Execution (1));
  for (std::uint32_t node = 0; node < graph->size (); ++node)
    for (const std::uint32_t neighbor : farRow (*graph, rows, node))
      EXPECT_EQ (nodes.base[neighbor].z (), nodes.base[node].z ());
}

TEST (FarRowsTest, FarFromTheOriginTheyAreTheSame)
{
  const Searched cloud (withNoise (planeGrid (20, 0.25f).points, 0.02, 4), {32});
  Positions moved = cloud.nodes;
  for (std::size_t i = 0; i < moved.size (); ++i) { // base: what float can represent there; offset: the remainder
    const Eigen::Vector3f place = moved.base[i];
    moved.base[i] = (place.array () + 32768).round ().matrix ();
    moved.offset[i] += place - (moved.base[i].array () - 32768).matrix ();
  }
  const FarRows here (*cloud.graph, nodeArrays (cloud.nodes), Execution (2));
  const FarRows there (*cloud.graph, nodeArrays (moved), Execution (2));
  for (std::uint32_t node = 0; node < cloud.graph->size (); ++node)
    EXPECT_EQ (farRow (*cloud.graph, there, node), farRow (*cloud.graph, here, node)) << node;
}
} // namespace
