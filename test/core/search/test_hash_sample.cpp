// SPDX-License-Identifier: BSD-3-Clause
#include "graph_rows.h"
#include "shapes.h"

#include <core/search/hash_sample.h>

#include <gtest/gtest.h>

#include <set>

namespace
{
using namespace pcl_normal_smoothing::core;
using namespace test_support;

std::set<std::uint32_t>
hashesOf (const Positions& cloud, const std::vector<std::uint32_t>& nodes)
{
  std::set<std::uint32_t> hashes;
  for (const std::uint32_t node : nodes)
    hashes.insert (hashOf (cloud, node));
  return hashes;
}

TEST (HashSampleTest, AreThePlacesWithTheSmallestHashesHoweverOftenTheyAreThere)
{
  const Vectors points = sphere (9000, 1).points;
  const std::set<std::uint32_t> expected =
      hashesOf (asPositions (points), sampleNodes (asPositions (points), 700, Execution (2)));
  ASSERT_EQ (expected.size (), 700u);
  Vectors many (300000, points[4321]); // as scanners write for points that they did not measure
  for (int copy = 0; copy < 3; ++copy)
    many.insert (many.end (), points.rbegin (), points.rend ());
  const std::vector<std::uint32_t> sample = sampleNodes (asPositions (many), 700, Execution (2));
  EXPECT_EQ (hashesOf (asPositions (many), sample), expected);
  EXPECT_GE (sample.size (), 3 * 700u);
}

TEST (HashSampleTest, ASmallerOneIsPartOfALargerOne)
{
  const Positions cloud = asPositions (sphere (9000, 1).points);
  const auto small = hashesOf (cloud, sampleNodes (cloud, 100, Execution (1))),
             large = hashesOf (cloud, sampleNodes (cloud, 1000, Execution (2)));
  EXPECT_EQ (small.size (), 100u);
  EXPECT_TRUE (std::includes (large.begin (), large.end (), small.begin (), small.end ()));
}

TEST (HashSampleTest, AllOfACloudThatIsSmaller)
{
  const Positions cloud = asPositions (sphere (60, 1).points);
  for (const std::size_t size : {60, 61, 4096})
    EXPECT_EQ (sampleNodes (cloud, size, Execution (2)).size (), 60u);
  EXPECT_TRUE (sampleNodes ({}, 5, Execution (1)).empty ());
}

TEST (HashSampleTest, LimitsOfAStreamAreThoseOfTheCloud)
{
  const Positions cloud = asPositions (sphere (9000, 1).points);
  SmallestHashes smallest (4096);
  for (std::size_t i = 0; i < cloud.size (); ++i)
    smallest.add (hashOf (cloud, i));
  for (const std::size_t size : {1, 1000, 4096})
    EXPECT_EQ (nodesUpTo (smallest.limitFor (size), cloud, Execution (2)), sampleNodes (cloud, size, Execution (2)));
}

/** A grid of \a side x \a side points .01 apart, at coordinates where floats are half a unit apart. */
Positions
farGrid (int side)
{
  Positions far;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const Eigen::Vector3d point (4e6 + .01 * i, 8e6 + .01 * j, 5e6);
      far.base.push_back (point.cast<float> ());
      far.offset.push_back ((point - far.base.back ().cast<double> ()).cast<float> ());
    }
  return far;
}

TEST (HashSampleTest, IsAsLargeFarFromTheOrigin)
{
  const Positions far = farGrid (200);
  for (const std::size_t size : {500, 4000}) {
    const auto sample = static_cast<double> (sampleNodes (far, size, Execution (1)).size ());
    EXPECT_NEAR (sample / static_cast<double> (size), 1, .15);
  }
}
} // namespace
