// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_normal_smoothing
{
namespace core
{
/** The nodes below \a count that satisfy a condition, ascending. */
template <typename Condition>
std::vector<std::uint32_t>
nodesWhere (std::size_t count, const Condition& holds)
{
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t node = 0; node < count; ++node)
    if (holds (node))
      nodes.push_back (node);
  return nodes;
}
} // namespace core
} // namespace pcl_normal_smoothing
