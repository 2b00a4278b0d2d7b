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
/** The places of a cloud with the smallest hashes of their coordinates are its samples: whatever the order of the
  * points, however many lie in one place, and so that a smaller sample is part of a larger one. */
class SmallestHashes
{
public:
  /** \param[in] count as many as the largest sample has, at least one */
  explicit SmallestHashes (std::size_t count) : count_ (count) {}

  /** \param[in] hash see hashOf; any number of times */
  void
  add (std::uint32_t hash)
  {
    if (hashes_.size () == count_ && hash >= *hashes_.rbegin ())
      return;
    hashes_.insert (hash);
    if (hashes_.size () > count_)
      hashes_.erase (std::prev (hashes_.end ()));
  }

  /** \return whose hashes are up to this is in a sample of so many places; there may be fewer, and then all are */
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

/** Nodes of a cloud, or of a part of it, whose hashes are up to \a limit, ascending. */
std::vector<std::uint32_t>
nodesUpTo (std::uint32_t limit, const Positions& nodes, const Execution& execution);

/** Those of a whole cloud that are in a sample of \a size places. */
std::vector<std::uint32_t>
sampleNodes (const Positions& nodes, std::size_t size, const Execution& execution);
} // namespace core
} // namespace pcl_normal_smoothing
