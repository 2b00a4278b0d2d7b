// SPDX-License-Identifier: BSD-3-Clause
#include "searched.h"

#include <core/search/thinned_cloud.h>

#include <gtest/gtest.h>

#include <set>

namespace
{
using namespace pcl_normal_smoothing::core;
using namespace test_support;

constexpr std::size_t size = 60000;
constexpr std::uint32_t row_length = 16;

Vectors
square ()
{
  Vectors points;
  for (std::uint64_t i = 0; i < size; ++i)
    points.push_back (Eigen::Vector3d (uniformNoise (1, i), uniformNoise (2, i), 0).cast<float> ());
  return points;
}

/** The set of all nodes' neighbours. */
std::set<std::uint32_t>
neighborsIn (const Searched& cloud, int halvings, ThinnedCloud::Parts parts)
{
  const ThinnedCloud thinned (*cloud.graph, cloud.nodes, halvings, parts, Execution (2));
  std::set<std::uint32_t> neighbors;
  KdTree::Scratch scratch;
  std::uint32_t row[row_length];
  for (std::uint32_t node = 0; node < cloud.nodes.size (); ++node) {
    thinned.row (node, row, row_length, scratch);
    EXPECT_EQ (row[0], node);
    neighbors.insert (row + 1, row + row_length);
  }
  return neighbors;
}

TEST (ThinnedCloudTest, NeighboursAreOfOnePartOrOfMore)
{
  const Searched cloud (square ());
  constexpr int halvings = 5;
  const double part = static_cast<double> (size) / (1 << halvings);
  using Parts = ThinnedCloud::Parts;
  EXPECT_NEAR (static_cast<double> (neighborsIn (cloud, halvings, Parts::ONE).size ()), part, 0.1 * part);
  EXPECT_NEAR (static_cast<double> (neighborsIn (cloud, halvings, Parts::SOME).size ()), 16 * part, 0.1 * 16 * part);
  EXPECT_NEAR (static_cast<double> (neighborsIn (cloud, halvings, Parts::ALL).size ()), size, 0.1 * size);
}

TEST (ThinnedCloudTest, AHalfIsEnoughWhereItHasMany)
{
  const Searched cloud (square ());
  EXPECT_NEAR (static_cast<double> (neighborsIn (cloud, 1, ThinnedCloud::Parts::SOME).size ()), size / 2, 0.05 * size);
}
} // namespace
