// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../shapes.h"

#include <core/search/kd_tree.h>

#include <string>

namespace test_support
{
/** A cloud that is difficult to search in some way. */
struct NamedCloud
{
  std::string name;
  Positions positions;
};

inline void
PrintTo (const NamedCloud& cloud, std::ostream* out)
{
  *out << cloud.name;
}

/** Uniform, clustered, planar, collinear, duplicated, all equal, on an integer grid, far away, in double, with squares
  * of distances too small for float, and of 17, 3 and 1 points. */
std::vector<NamedCloud>
hardClouds ();

/** Summed in the order that the tree promises, (dx^2 + dy^2) + dz^2 in float, so that rows can be compared exactly. */
float
squaredDistance (const Positions& cloud, std::uint32_t i, std::uint32_t j);

using IndexRow = std::vector<std::uint32_t>;

/** The row of one point by comparison with all others: itself first, then by (squared distance, index). */
IndexRow
bruteForceRow (const Positions& cloud, std::uint32_t point, const pcl_normal_smoothing::core::NeighborQuery& query);
} // namespace test_support
