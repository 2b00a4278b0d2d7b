// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../shapes.h"

#include <core/search/kd_tree.h>

#include <string>

namespace test_support
{
/** A cloud that is hard on a search in its own way. */
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

/** Uniform, clustered, planar, collinear, duplicated, all equal, on an integer grid, far away, and in double. */
std::vector<NamedCloud>
hardClouds ();

/** Summed as the tree promises to, (dx^2 + dy^2) + dz^2 in float, so that rows can be compared exactly. */
float
squaredDistance (const Positions& cloud, std::uint32_t i, std::uint32_t j);

using IndexRow = std::vector<std::uint32_t>;

/** The row of one point by comparing with all: itself first, then by (squared distance, index). */
IndexRow
bruteForceRow (const Positions& cloud, std::uint32_t point, const pcl_normal_smoothing::core::NeighborQuery& query);
} // namespace test_support
