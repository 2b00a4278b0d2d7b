// SPDX-License-Identifier: BSD-3-Clause
#include "common_options.h"

#include "files/tool_error.h"

#include <pcl_normal_smoothing/input_checks.h>

#include <limits>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
const Words<FileFormat> formats {{"ascii", FileFormat::ASCII},
                                 {"binary", FileFormat::BINARY},
                                 {"compressed", FileFormat::COMPRESSED}};
} // namespace

void
addSeedOption (Options& options, const std::string& standard, const std::function<void (std::uint64_t)>& use)
{
  options.add ("-seed", "N", "seed of the random numbers", standard,
               integerOption (0, std::numeric_limits<std::int64_t>::max (),
                              [use] (std::int64_t seed) { use (static_cast<std::uint64_t> (seed)); }));
}

void
addThreadsOption (Options& options, unsigned& threads)
{
  options.add ("-threads", "N", "threads, 0 = all cores; the result does not depend on it", "0",
               integerOption (0, 1024, [&] (std::int64_t number) { threads = static_cast<unsigned> (number); }));
}

void
SearchOptions::addTo (Options& options, const std::string& k_standard, int least_k, const std::string& more)
{
  options.add ("-k", "N", "neighbours of a point, itself included, at least " + std::to_string (least_k) + more,
               k_standard,
               integerOption (least_k, 100000, [this] (std::int64_t number) { k = static_cast<int> (number); }));
  options.add ("-radius", "R", "in place of -k: all neighbours closer than this, in the cloud's unit", "none",
               positiveOption ([this] (double length) { radius = length; }));
  options.add ("-max_radius", "R", "of the k neighbours only those closer than this, in the cloud's unit", "no limit",
               positiveOption ([this] (double length) { max_radius = length; }));
  addThreadsOption (options, threads);
}

core::NeighborQuery
SearchOptions::query (int k_if_unset) const
{
  if (k > 0 && radius > 0)
    throw UsageError ("-k and -radius are both given: give one of them, or limit -k by -max_radius");
  return makeNeighborQuery (k == 0 && radius == 0 ? k_if_unset : k, radius, max_radius);
}

void
FormatOption::addTo (Options& options)
{
  options.add ("-format", wordList (formats), "of the output; compressed is PCD's only", "binary",
               choiceOption<FileFormat> (formats, [this] (auto chosen) { format = chosen; }));
}
} // namespace tools
} // namespace pcl_normal_smoothing
