// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace pcl_normal_smoothing
{
namespace core
{
/** Number of nodes in a block of NeighborGraph, and of triples of points that vote together: the work of one kernel
  * call. A multiple of every instruction set's number of lanes. */
constexpr std::size_t block_size = 16;
} // namespace core
} // namespace pcl_normal_smoothing
