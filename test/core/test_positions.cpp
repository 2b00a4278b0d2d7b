// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/positions.h>

#include <gtest/gtest.h>

#include <limits>

namespace
{
using namespace pcl_normal_smoothing::core;

Positions
withoutOffsets (std::size_t size)
{
  return {Vectors (size, Eigen::Vector3f::Ones ()), Vectors (size, Eigen::Vector3f::Zero ())};
}

TEST (Positions, AnOffsetAnywhereIsSeen)
{
  EXPECT_FALSE (hasOffsets (withoutOffsets (0)));
  for (const std::size_t size : {1, 1023, 1024, 1025, 5000}) {
    Positions positions = withoutOffsets (size);
    EXPECT_FALSE (hasOffsets (positions)) << size;
    positions.offset.back ().z () = std::numeric_limits<float>::denorm_min ();
    EXPECT_TRUE (hasOffsets (positions)) << size;
    positions.offset.back ().z () = -0.0f;
    EXPECT_FALSE (hasOffsets (positions)) << size;
    positions.offset.front ().x () = std::numeric_limits<float>::quiet_NaN ();
    EXPECT_TRUE (hasOffsets (positions)) << size;
  }
}

TEST (Positions, LargeArraysHoldWhatTheyAreGiven)
{
  for (const std::size_t size : {349523, 349526, 500000, 1048576}) { // of 12 bytes: about two large pages, and more
    Vectors vectors (size, Eigen::Vector3f (1, 2, 3));
    const Vectors copy = vectors;
    vectors.resize (size / 100);
    vectors.shrink_to_fit (); // back to memory without large pages
    EXPECT_EQ (copy.back (), Eigen::Vector3f (1, 2, 3));
    EXPECT_EQ (vectors.back (), Eigen::Vector3f (1, 2, 3));
  }
}
} // namespace
