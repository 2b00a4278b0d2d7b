// SPDX-License-Identifier: BSD-3-Clause
#include "hash_sample.h"

#include <algorithm>
#include <iterator>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
constexpr auto all = std::numeric_limits<std::uint32_t>::max ();

/** A limit on hashes that includes at least \a size nodes, and hardly more than twice as many, if all have different
  * places. */
std::uint32_t
generousLimit (std::size_t nodes, std::size_t size)
{
  const double share = 2 * static_cast<double> (size) / static_cast<double> (std::max<std::size_t> (nodes, 1));
  return share < 1 ? static_cast<std::uint32_t> (share * all) : all;
}
} // namespace

std::vector<std::uint32_t>
nodesUpTo (std::uint32_t limit, const Positions& nodes, const Execution& execution)
{
  constexpr std::size_t part_size = 1 << 16;
  std::vector<std::vector<std::uint32_t>> parts (nodes.size () / part_size + 1);
  const auto find = [&] (std::size_t begin, std::size_t end) {
    for (std::size_t node = begin * part_size; node < std::min (end * part_size, nodes.size ()); ++node)
      if (hashOf (nodes, node) <= limit)
        parts[node / part_size].push_back (static_cast<std::uint32_t> (node));
  };
  parallelFor (parts.size (), execution.silent (), find, 1);
  std::vector<std::uint32_t> found;
  for (const auto& part : parts)
    found.insert (found.end (), part.begin (), part.end ());
  return found;
}

std::vector<std::uint32_t>
sampleNodes (const Positions& nodes, std::size_t size, const Execution& execution)
{
  for (std::uint32_t generous = generousLimit (nodes.size (), size);; generous = all) {
    const std::vector<std::uint32_t> candidates = nodesUpTo (generous, nodes, execution);
    SmallestHashes smallest (size);
    for (const std::uint32_t node : candidates)
      smallest.add (hashOf (nodes, node));
    const std::uint32_t limit = smallest.limitFor (size);
    if (limit == all && generous != all)
      continue;
    std::vector<std::uint32_t> sample;
    std::copy_if (candidates.begin (), candidates.end (), std::back_inserter (sample),
                  [&] (std::uint32_t node) { return hashOf (nodes, node) <= limit; });
    return sample;
  }
}
} // namespace core
} // namespace pcl_normal_smoothing
