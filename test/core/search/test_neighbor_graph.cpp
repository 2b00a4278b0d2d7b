// SPDX-License-Identifier: BSD-3-Clause
#include "graph_rows.h"

#include <pcl_normal_smoothing/core/error.h>
#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

namespace
{
using namespace pcl_normal_smoothing::core;
using namespace test_support;

constexpr float no_radius = std::numeric_limits<float>::infinity ();
constexpr float nan_float = std::numeric_limits<float>::quiet_NaN ();

std::size_t
shortestRow (const NeighborGraph& graph)
{
  std::size_t length = graph.size ();
  for (std::size_t node = 0; node < graph.size (); ++node)
    length = std::min (length, graph.row (node).size ());
  return length;
}

class NeighborGraphTest : public testing::TestWithParam<NamedCloud>
{
protected:
  static void
  expectExact (const NeighborGraph& graph, const Positions& cloud, const NeighborQuery& query)
  {
    ASSERT_EQ (graph.size (), cloud.size ());
    for (std::size_t node = 0; node < graph.size (); ++node)
      ASSERT_EQ (rowInCloud (graph, node), bruteForceRow (cloud, graph.order ()[node], query)) << "node " << node;
    EXPECT_EQ (graph.minRowLength (), shortestRow (graph));
  }

  /** A search that returns its neighbours unsorted: here, in reverse order. */
  static NeighborGraph::Search
  unorderedSearch (const Positions& cloud, const NeighborQuery& query)
  {
    return [&cloud, query] (std::uint32_t index, std::vector<std::uint32_t>& neighbors) {
      neighbors = bruteForceRow (cloud, index, query);
      std::reverse (neighbors.begin (), neighbors.end ());
    };
  }
};

TEST_P (NeighborGraphTest, RowsAreThoseOfBruteForce)
{
  const Positions& cloud = GetParam ().positions;
  for (const NeighborQuery& query : {NeighborQuery {7, no_radius}, NeighborQuery {0, 0.8f}, NeighborQuery {9, 1.2f}})
    expectExact (*NeighborGraph::build (cloud, query, Execution (2)), cloud, query);
}

TEST_P (NeighborGraphTest, RowsOfASearchObjectAreTheSame)
{
  const Positions& cloud = GetParam ().positions;
  for (const NeighborQuery& query : {NeighborQuery {7, no_radius}, NeighborQuery {0, 0.8f}})
    expectExact (*NeighborGraph::build (cloud, unorderedSearch (cloud, query), Execution (2)), cloud, query);
}

TEST_P (NeighborGraphTest, HoldsAllPointsWhereThereAreFewerThanK)
{
  const Positions& cloud = GetParam ().positions;
  const auto graph = NeighborGraph::build (cloud, {1200, no_radius}, Execution (2));
  expectExact (*graph, cloud, {1200, no_radius});
  for (std::size_t node = 0; node < graph->size (); ++node)
    ASSERT_EQ (graph->row (node).size (), cloud.size ());
}

TEST_P (NeighborGraphTest, RebuiltAfterMotionItFindsTheMovedNeighbours)
{
  const Positions& cloud = GetParam ().positions;
  const auto graph = NeighborGraph::build (cloud, {5, no_radius}, Execution (2));
  Positions moved = cloud;
  for (std::size_t i = 0; i < moved.size (); ++i)
    for (int d = 0; d < 3; ++d)
      moved.offset[i][d] += static_cast<float> (uniformNoise (20, 3 * i + std::uint64_t (d)));
  const Positions nodes = gather (moved, graph->order ());
  for (const NeighborQuery& query : {NeighborQuery {7, no_radius}, NeighborQuery {0, 0.8f}}) {
    const auto rebuilt = graph->rebuild (nodes, query, Execution (2));
    EXPECT_EQ (rebuilt->order (), graph->order ());
    expectExact (*rebuilt, moved, query);
    expectExact (*graph->rebuild (nodes, unorderedSearch (moved, query), Execution (2)), moved, query);
  }
}

TEST_P (NeighborGraphTest, AroundSomePointsTheRowsWithinTheHopsAreThoseOfAll)
{
  const Positions& cloud = GetParam ().positions;
  const auto size = static_cast<std::uint32_t> (cloud.size ());
  const std::set<std::uint32_t> some = {7 % size, 3 % size, size - 1};
  const Elements start (some.rbegin (), some.rend ());
  for (const NeighborQuery& query : {NeighborQuery {7, no_radius}, NeighborQuery {0, 0.8f}, NeighborQuery {9, 1.2f}}) {
    const auto graph = NeighborGraph::buildAround (cloud, start, 2, query, Execution (2));
    std::set<std::uint32_t> reached (start.begin (), start.end ()), all = reached;
    for (int hop = 0; hop <= 2; ++hop) {
      reached = all;
      for (const std::uint32_t point : reached)
        for (const std::uint32_t neighbor : bruteForceRow (cloud, point, query))
          all.insert (neighbor);
    }
    ASSERT_EQ (graph->cloudSize (), cloud.size ());
    EXPECT_EQ (std::set<std::uint32_t> (graph->order ().begin (), graph->order ().end ()), all);
    ASSERT_EQ (graph->size (), all.size ()) << "a node is there twice";
    for (std::size_t node = 0; node < graph->size (); ++node) {
      const std::uint32_t point = graph->order ()[node];
      EXPECT_TRUE (node >= start.size () || point == start[node]) << "node " << node;
      ASSERT_EQ (rowInCloud (*graph, node),
                 reached.count (point) > 0 ? bruteForceRow (cloud, point, query) : IndexRow {point})
          << "node " << node;
    }
  }
}

INSTANTIATE_TEST_SUITE_P (Clouds, NeighborGraphTest, testing::ValuesIn (hardClouds ()), [] (const auto& cloud) {
  return cloud.param.name;
});

TEST (NeighborGraph, LeavesOutPointsThatAreNotFinite)
{
  const Positions all = hardClouds ().front ().positions;
  Positions cloud = all;
  for (std::size_t i = 0; i < cloud.size (); i += 3)
    cloud.base[i][static_cast<int> (i / 3 % 3)] = i % 2 == 0 ? nan_float : no_radius;
  const auto graph = NeighborGraph::build (cloud, {6, no_radius}, Execution (2));
  EXPECT_EQ (graph->cloudSize (), cloud.size ());
  EXPECT_EQ (graph->size (), cloud.size () - (cloud.size () + 2) / 3);
  const auto rows = rowsByPoint (*graph);
  for (std::uint32_t i = 0; i < cloud.size (); ++i) {
    EXPECT_EQ (rows[i].empty (), i % 3 == 0) << "point " << i;
    for (const std::uint32_t j : rows[i])
      EXPECT_NE (j % 3, 0u) << "a neighbour of point " << i;
  }
  EXPECT_EQ (finiteElements (cloud).size (), graph->size ());
}

TEST (NeighborGraph, KnowsItsShortestRowWhenSomeRowsAreOthers)
{
  const Positions cloud = hardClouds ().front ().positions;
  const auto graph = NeighborGraph::build (cloud, {7, no_radius}, Execution (2));
  const auto changed = graph->withRows ({3, 40, 41}, {3, 4, 5, 40, 41, 40, 41, 40, 42}, 3);
  EXPECT_EQ (changed->minRowLength (), shortestRow (*changed));
  EXPECT_EQ (changed->minRowLength (), 2u);
  EXPECT_EQ (graph->minRowLength (), 7u);
}

TEST (NeighborGraph, IsEmptyWhereNoPointIsFinite)
{
  Positions cloud = asPositions (Vectors (5, Eigen::Vector3f::Constant (nan_float)));
  for (const Positions& none : {cloud, Positions ()}) {
    const auto graph = NeighborGraph::build (none, {6, no_radius}, Execution (2));
    EXPECT_EQ (graph->size (), 0u);
    EXPECT_EQ (graph->cloudSize (), none.size ());
    EXPECT_EQ (graph->rebuild ({}, {6, no_radius}, Execution (2))->size (), 0u);
  }
}

TEST (NeighborGraph, RefusesIndicesThatTheCloudDoesNotHave)
{
  Positions cloud = hardClouds ().front ().positions;
  cloud.base[4].x () = nan_float;
  for (const std::uint32_t wrong : {4u, 500u, ~0u}) {
    const auto search = [wrong] (std::uint32_t, std::vector<std::uint32_t>& neighbors) { neighbors = {0, 1, wrong}; };
    try {
      NeighborGraph::build (cloud, search, Execution (2));
      FAIL () << "index " << wrong << " was accepted";
    }
    catch (const Error& error) {
      EXPECT_NE (std::string (error.what ()).find (std::to_string (wrong)), std::string::npos) << error.what ();
    }
  }
}

TEST (NeighborGraph, TheNodesDoNotDependOnTheThreads)
{
  const Positions cloud = asPositions (torus (20000, 1, 0.4).points); // many chunks
  const auto one = NeighborGraph::build (cloud, {8, no_radius}, Execution (1));
  for (const unsigned threads : {2u, 4u}) {
    const auto many = NeighborGraph::build (cloud, {8, no_radius}, Execution (threads));
    EXPECT_EQ (many->order (), one->order ());
    EXPECT_EQ (rowsByPoint (*many), rowsByPoint (*one));
  }
}
} // namespace
