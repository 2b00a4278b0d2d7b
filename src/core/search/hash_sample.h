// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/parallel_for.h>
#include <pcl_normal_smoothing/core/positions.h>

#include <limits>
#include <set>

namespace pcl_normal_smoothing
{
namespace core
{
/** Samples of a cloud are the places with the smallest hashes of their coordinates: independent of the order of
  * points and of how many share a place, and nested, so that a smaller sample is part of a larger one. */
class SmallestHashes
{
public:
  /** \param[in] count size of the largest sample, at least one */
  explicit SmallestHashes (std::size_t count) : count_ (count) {}

  /** \param[in] hash see hashOf; may be added any number of times */
  void
  add (std::uint32_t hash)
  {
    if (hashes_.size () == count_ && hash >= *hashes_.rbegin ())
      return;
    hashes_.insert (hash);
    if (hashes_.size () > count_)
      hashes_.erase (std::prev (hashes_.end ()));
  }

  /** \return upper bound on the hashes in a sample of \a size places; if there are fewer places, it includes all */
  std::uint32_t
  limitFor (std::size_t size) const
  {
    return hashes_.size () < size ? std::numeric_limits<std::uint32_t>::max ()
                                  : *std::next (hashes_.begin (), static_cast<std::ptrdiff_t> (size) - 1);
  }

private:
  std::size_t count_;
  std::set<std::uint32_t> hashes_;
};

/** Nodes of a cloud, or of a part of it, with hashes up to \a limit, ascending. */
std::vector<std::uint32_t>
nodesUpTo (std::uint32_t limit, const Positions& nodes, const Execution& execution);

/** Nodes of a whole cloud that are in a sample of \a size places. */
std::vector<std::uint32_t>
sampleNodes (const Positions& nodes, std::size_t size, const Execution& execution);
} // namespace core
} // namespace pcl_normal_smoothing
