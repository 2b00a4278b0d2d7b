// SPDX-License-Identifier: BSD-3-Clause
#include "neighbor_clouds.h"

#include <core/search/kd_tree.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
using namespace pcl_normal_smoothing::core;
using namespace test_support;

constexpr float no_radius = std::numeric_limits<float>::infinity ();

class KdTreeTest : public testing::TestWithParam<NamedCloud>
{
protected:
  /** The rows of all points, the points themselves first. */
  static std::vector<IndexRow>
  searchAll (const Positions& cloud, const NeighborQuery& query, const Elements& rank = {})
  {
    const Execution execution (2);
    const KdTree tree (cloud, rank, execution);
    std::vector<IndexRow> rows (cloud.size (), IndexRow {~0u}); // poison: every row must be visited
    tree.searchAll (query, execution, [&] (std::uint32_t slot, const std::vector<Neighbor>& found) {
      const std::uint32_t point = tree.order ()[slot];
      rows[point] = {point};
      for (const Neighbor& neighbor : found)
        rows[point].push_back (tree.order ()[neighbor.slot]);
    });
    return rows;
  }

  static void
  expectExact (const Positions& cloud, const NeighborQuery& query)
  {
    const std::vector<IndexRow> rows = searchAll (cloud, query);
    for (std::uint32_t i = 0; i < cloud.size (); ++i)
      ASSERT_EQ (rows[i], bruteForceRow (cloud, i, query))
          << "point " << i << ", k " << query.k << ", radius " << query.radius;
  }
};

TEST_P (KdTreeTest, FindsTheNearestAsBruteForceDoes)
{
  for (const std::uint32_t k : {1u, 2u, 7u, 16u, 40u, 100u})
    expectExact (GetParam ().positions, {k, no_radius});
}

TEST_P (KdTreeTest, FindsAllWithMoreNeighboursThanPoints)
{
  expectExact (GetParam ().positions, {2000, no_radius});
  expectExact (GetParam ().positions, {2147483647, no_radius});
}

TEST_P (KdTreeTest, FindsAllWithinARadius)
{
  for (const float radius : {1e-4f, 0.1f, 1.0f, 2.0f, 40.0f})
    expectExact (GetParam ().positions, {0, radius});
}

TEST_P (KdTreeTest, FindsTheNearestWithinARadius)
{
  for (const float radius : {0.1f, 1.0f, 1.5f, 40.0f})
    expectExact (GetParam ().positions, {8, radius});
}

TEST_P (KdTreeTest, AnswersQueriesAtThePointsThemselves)
{
  const Positions& cloud = GetParam ().positions;
  const KdTree tree (cloud, {}, Execution (1));
  KdTree::Scratch scratch;
  for (std::uint32_t i = 0; i < cloud.size (); i += 3) {
    const auto& found = tree.search (cloud.base[i], cloud.offset[i], {9, no_radius}, scratch);
    // The tree does not know which point queries, so a duplicate may precede it; but the distances must be the same.
    const IndexRow expected = bruteForceRow (cloud, i, {9, no_radius});
    ASSERT_EQ (found.size (), expected.size ());
    for (std::size_t j = 0; j < found.size (); ++j)
      EXPECT_EQ (found[j].sq_dist, squaredDistance (cloud, i, expected[j])) << "point " << i;
    EXPECT_TRUE (std::is_sorted (found.begin (), found.end ()));
  }
}

TEST_P (KdTreeTest, AnswersQueriesBesideThePoints)
{
  const Positions& cloud = GetParam ().positions;
  const Eigen::Vector3f moves[] = {{0.3f, -0.2f, 0.1f}, {30, 0, 0}, {-1e4f, 2e4f, 0}};
  for (const auto& move : moves)
    for (const NeighborQuery& query : {NeighborQuery {6, no_radius}, NeighborQuery {0, 35}, NeighborQuery {6, 35}}) {
      Positions with_query = cloud;
      with_query.base.push_back (cloud.base[0] + move);
      with_query.offset.push_back (cloud.offset[0]);
      NeighborQuery one_more = query;
      one_more.k += query.k > 0; // brute force counts the query point itself
      IndexRow expected = bruteForceRow (with_query, static_cast<std::uint32_t> (cloud.size ()), one_more);
      expected.erase (expected.begin ());

      const KdTree tree (cloud, {}, Execution (1));
      KdTree::Scratch scratch;
      IndexRow row;
      for (const Neighbor& neighbor : tree.search (with_query.base.back (), cloud.offset[0], query, scratch))
        row.push_back (tree.order ()[neighbor.slot]);
      EXPECT_EQ (row, expected) << move.transpose ();
    }
}

TEST_P (KdTreeTest, TiesGoToTheLowestRank)
{
  const Positions& cloud = GetParam ().positions;
  const auto numbers = permutation (cloud.size (), 17);
  const Elements rank (numbers.begin (), numbers.end ());
  // The cloud sorted by rank, so that rank and index are equal.
  std::vector<std::uint32_t> by_rank (cloud.size ());
  for (std::uint32_t i = 0; i < cloud.size (); ++i)
    by_rank[rank[i]] = i;
  Positions ranked;
  for (const std::uint32_t i : by_rank) {
    ranked.base.push_back (cloud.base[i]);
    ranked.offset.push_back (cloud.offset[i]);
  }
  const std::vector<IndexRow> rows = searchAll (cloud, {7, no_radius}, rank);
  for (std::uint32_t i = 0; i < cloud.size (); ++i) {
    IndexRow expected = bruteForceRow (ranked, rank[i], {7, no_radius});
    for (auto& j : expected)
      j = by_rank[j];
    ASSERT_EQ (rows[i], expected) << "point " << i;
  }
}

TEST_P (KdTreeTest, SlotsAreAPermutation)
{
  const KdTree tree (GetParam ().positions, {}, Execution (2));
  IndexRow order (tree.order ().begin (), tree.order ().end ());
  std::sort (order.begin (), order.end ());
  for (std::uint32_t i = 0; i < order.size (); ++i)
    ASSERT_EQ (order[i], i);
  EXPECT_EQ (order.size (), GetParam ().positions.size ());
}

INSTANTIATE_TEST_SUITE_P (Clouds, KdTreeTest, testing::ValuesIn (hardClouds ()), [] (const auto& cloud) {
  return cloud.param.name;
});
} // namespace
