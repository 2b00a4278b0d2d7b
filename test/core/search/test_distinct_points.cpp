// SPDX-License-Identifier: BSD-3-Clause
#include "graph_rows.h"

#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>

namespace
{
using namespace pcl_normal_smoothing::core;
using namespace test_support;

constexpr float no_radius = std::numeric_limits<float>::infinity ();

/** For every point, the first point in the same place, found by comparison with all before it. */
std::vector<std::uint32_t>
firstInPlace (const Positions& cloud)
{
  std::map<std::array<float, 6>, std::uint32_t> first;
  std::vector<std::uint32_t> result;
  for (std::uint32_t i = 0; i < cloud.size (); ++i) {
    const Eigen::Vector3f &b = cloud.base[i], &o = cloud.offset[i];
    result.push_back (first.try_emplace ({b.x (), b.y (), b.z (), o.x (), o.y (), o.z ()}, i).first->second);
  }
  return result;
}

/** The first point of each place. \param[out] numbers their indices in \a cloud */
Positions
distinctOf (const Positions& cloud, std::vector<std::uint32_t>& numbers)
{
  const std::vector<std::uint32_t> first = firstInPlace (cloud);
  Positions distinct;
  for (std::uint32_t i = 0; i < cloud.size (); ++i)
    if (first[i] == i) {
      distinct.base.push_back (cloud.base[i]);
      distinct.offset.push_back (cloud.offset[i]);
      numbers.push_back (i);
    }
  return distinct;
}

class DistinctPoints : public testing::TestWithParam<NamedCloud>
{
protected:
  DistinctPoints () : distinct_ (distinctOf (cloud_, numbers_)) {}

  /** The expected row of a point among the distinct ones, in indices of the whole cloud. */
  IndexRow
  expectedRow (std::uint32_t point, const NeighborQuery& query) const
  {
    const auto place = std::lower_bound (numbers_.begin (), numbers_.end (), point) - numbers_.begin ();
    IndexRow row = bruteForceRow (distinct_, static_cast<std::uint32_t> (place), query);
    std::transform (row.begin (), row.end (), row.begin (), [this] (std::uint32_t i) { return numbers_[i]; });
    return row;
  }

  void
  expectRows (const NeighborGraph& graph, const NeighborQuery& query) const
  {
    for (std::size_t node = 0; node < graph.size (); ++node)
      ASSERT_EQ (rowInCloud (graph, node), expectedRow (graph.order ()[node], query)) << "node " << node;
  }

  const Positions& cloud_ = GetParam ().positions;
  std::vector<std::uint32_t> numbers_; // indices of the distinct points
  Positions distinct_;
};

TEST_P (DistinctPoints, EveryCopyHasTheFirstPointInItsPlace)
{
  const std::vector<std::uint32_t> first = firstInPlace (cloud_);
  Elements points = finiteElements (cloud_);
  const Copies copies = takeOutCopies (cloud_, Execution (2), points);
  EXPECT_EQ (std::vector<std::uint32_t> (points.begin (), points.end ()), numbers_);
  ASSERT_EQ (copies.points.size () + points.size (), cloud_.size ());
  for (std::size_t i = 0; i < copies.points.size (); ++i) {
    EXPECT_EQ (copies.originals[i], first[copies.points[i]]);
    EXPECT_NE (copies.originals[i], copies.points[i]);
  }
}

TEST_P (DistinctPoints, RowsAreThoseOfTheCloudWithoutCopies)
{
  const std::vector<std::uint32_t> first = firstInPlace (cloud_);
  for (const NeighborQuery& query :
       {NeighborQuery {7, no_radius, true}, NeighborQuery {0, 0.8f, true}, NeighborQuery {9, 1.2f, true}}) {
    const auto graph = NeighborGraph::build (cloud_, query, Execution (2));
    ASSERT_EQ (graph->size (), numbers_.size ());
    EXPECT_EQ (graph->finiteCount (), cloud_.size ());
    EXPECT_EQ (graph->cloudSize (), cloud_.size ());
    expectRows (*graph, query);
    for (std::size_t i = 0; i < graph->copies ().points.size (); ++i)
      EXPECT_EQ (graph->order ()[graph->copies ().originals[i]], first[graph->copies ().points[i]]);
  }
}

TEST_P (DistinctPoints, RowsOfASearchObjectNameNoCopies)
{
  const NeighborQuery query {0, 0.8f, true};
  const auto search = [&] (std::uint32_t index, std::vector<std::uint32_t>& neighbors) {
    neighbors = bruteForceRow (cloud_, index, query);
  };
  const auto graph = NeighborGraph::build (cloud_, search, Execution (2), true);
  ASSERT_EQ (graph->size (), numbers_.size ());
  expectRows (*graph, query);
}

TEST_P (DistinctPoints, AroundCopiesTheirOriginalsAreNodes)
{
  const NeighborQuery query {7, no_radius, true};
  const auto size = static_cast<std::uint32_t> (cloud_.size ());
  const Elements start = size < 4 ? Elements {size - 1} : Elements {size - 1, size / 2, size / 2 - 1};
  const auto graph = NeighborGraph::buildAround (cloud_, start, 0, query, Execution (2));
  const std::vector<std::uint32_t> first = firstInPlace (cloud_);
  EXPECT_EQ (graph->order ().front (), first[size - 1]);
  std::size_t copies = 0;
  for (std::uint32_t i = 0; i < size; ++i)
    copies += first[i] != i && std::count (graph->order ().begin (), graph->order ().end (), first[i]) > 0;
  EXPECT_EQ (graph->copies ().points.size (), copies);
  EXPECT_EQ (rowInCloud (*graph, 0), expectedRow (first[size - 1], query));
}

TEST_P (DistinctPoints, WhatNodesHoldIsThatOfTheirCopies)
{
  const auto graph = NeighborGraph::build (cloud_, {7, no_radius, true}, Execution (2));
  Vectors places = gather (cloud_, graph->order ()).base;
  graph->repeatForCopies (places);
  const Elements points = graph->points ();
  ASSERT_EQ (points.size (), cloud_.size ());
  for (std::size_t i = 0; i < points.size (); ++i)
    EXPECT_EQ (places[i], cloud_.base[points[i]]);
}

INSTANTIATE_TEST_SUITE_P (Clouds, DistinctPoints, testing::ValuesIn (hardClouds ()), [] (const auto& cloud) {
  return cloud.param.name;
});

TEST (DistinctPointsTest, OneBaseIsNotYetOnePlace)
{
  Positions cloud = asPositions (Vectors (4, Eigen::Vector3f (4e6f, 5e5f, 100)));
  cloud.offset[1].x () = cloud.offset[3].x () = 0.01f;
  Elements points = finiteElements (cloud);
  const Copies copies = takeOutCopies (cloud, Execution (1), points);
  EXPECT_EQ (points.size (), 2u);
  ASSERT_EQ (copies.points.size (), 2u);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_EQ (copies.originals[i] + 2, copies.points[i]);
}

TEST (DistinctPointsTest, NegativeZeroIsZero)
{
  Positions cloud = asPositions ({{0, 1, 2}, {-0.0f, 1, 2}});
  Elements points = finiteElements (cloud);
  EXPECT_EQ (takeOutCopies (cloud, Execution (1), points).points.size (), 1u);
}
} // namespace
