// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace pcl_normal_smoothing
{
namespace core
{
/** How many nodes make a block of NeighborGraph, and how many triples of points vote at once: what a kernel is called
  * for. The lanes of every instruction set divide it. */
constexpr std::size_t block_size = 16;
} // namespace core
} // namespace pcl_normal_smoothing
