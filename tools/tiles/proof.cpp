// SPDX-License-Identifier: BSD-3-Clause
#include "proof.h"

#include "region.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
/** Walks from hop to hop, and checks every row once. */
class Walk
{
public:
  Walk (const Neighborhoods& neighborhoods, const Depth& depth, const core::Execution& execution)
  : all_ (neighborhoods)
  , depth_ (depth)
  , execution_ (execution)
  , seen_ (neighborhoods.searched.size ())
  , gaps_ (neighborhoods.plan.cells.size (), -1)
  {}

  std::vector<Doubt>
  run (const std::vector<std::uint32_t>& wanted)
  {
    if (depth_.rows < 0 || all_.cells.allLoaded ())
      return {};
    findGaps ();
    for (const std::uint32_t node : wanted)
      seen_[node] = VISITED;
    nodes_ = wanted;
    std::size_t begin = 0;
    int hop = 0;
    for (; hop <= depth_.rows; ++hop)
      begin = look (all_.used, begin, depth_.rows - hop, hop < depth_.rows);
    // A separated row is made from searched rows: those of all nodes so far, and of the nodes around them.
    begin = 0;
    for (int farther = 0; farther <= depth_.separation; ++farther)
      begin = look (all_.searched, begin, 0, farther < depth_.separation);
    return std::move (doubts_);
  }

private:
  /** Checks the rows of nodes_ from \a begin on; if \a go_on, appends the nodes in them. \return where these begin */
  std::size_t
  look (const core::NeighborGraph& graph, std::size_t begin, int hops_left, bool go_on)
  {
    const std::size_t end = nodes_.size ();
    std::vector<std::uint32_t> visited;
    core::parallelFor (end - begin, execution_.silent (), [&] (std::size_t from, std::size_t to) {
      std::vector<Doubt> doubts;
      std::vector<std::uint32_t> nodes;
      for (std::size_t i = begin + from; i < begin + to; ++i) {
        const std::uint32_t node = nodes_[i];
        if ((seen_[node].fetch_or (CHECKED, std::memory_order_relaxed) & CHECKED) == 0 && !isCertain (node))
          doubts.push_back ({node, hops_left + std::max (depth_.separation, 0)});
        const core::Row row = graph.row (node);
        for (std::size_t j = 0; go_on && j < row.size (); ++j)
          if (isFirstVisit (row[j]))
            nodes.push_back (row[j]);
      }
      const std::lock_guard lock (mutex_);
      doubts_.insert (doubts_.end (), doubts.begin (), doubts.end ());
      visited.insert (visited.end (), nodes.begin (), nodes.end ());
    });
    nodes_.insert (nodes_.end (), visited.begin (), visited.end ());
    return end;
  }

  bool
  isFirstVisit (std::uint32_t node)
  {
    // Reading costs less than writing, and most nodes have been seen.
    return seen_[node].load (std::memory_order_relaxed) == 0 &&
           seen_[node].fetch_or (VISITED, std::memory_order_relaxed) == 0;
  }

  /** Computes the distance from every loaded cell to the nearest that is not. */
  void
  findGaps ()
  {
    core::parallelFor (
        gaps_.size (), execution_.silent (),
        [&] (std::size_t begin, std::size_t end) {
          for (auto cell = static_cast<std::uint32_t> (begin); cell < end; ++cell)
            if (all_.cells.isLoaded (cell))
              gaps_[cell] = all_.cells.distanceFrom (all_.plan.cells[cell].box);
        },
        256);
  }

  bool
  isCertain (std::uint32_t node) const
  {
    const double radius = all_.rowRadius (node);
    return radius < gaps_[all_.cellOf (node)] || !all_.cells.isNear (all_.placeOf (node), radius);
  }

  enum Seen : std::uint8_t
  {
    VISITED = 1,
    CHECKED = 2
  };

  const Neighborhoods& all_;
  const Depth& depth_;
  const core::Execution& execution_;
  std::mutex mutex_; // for what all threads append to
  std::vector<std::atomic<std::uint8_t>> seen_;
  std::vector<double> gaps_;
  std::vector<std::uint32_t> nodes_;
  std::vector<Doubt> doubts_;
};
} // namespace

Eigen::Vector3d
Neighborhoods::placeOf (std::uint32_t node) const
{
  return plan.unit * (nodes.base[node].cast<double> () + nodes.offset[node].cast<double> ());
}

double
Neighborhoods::rowRadius (std::uint32_t node) const
{
  // Bounds of the rounding errors: distances are compared in float, positions are sums of two floats, and squares may
  // underflow.
  constexpr double relative = 1e-5, tiny = 1e-17;
  const double lost = std::ldexp (static_cast<double> (nodes.base[node].lpNorm<Eigen::Infinity> ()), -40) + tiny;
  const core::Row row = searched.row (node);
  double radius = query.radius;
  if (query.k > 0 && row.size () >= query.k)
    radius = std::sqrt (static_cast<double> (core::squaredLength (nodes.difference (node, row[row.size () - 1]))));
  return plan.unit * (radius * (1 + relative) + lost);
}

std::vector<Doubt>
findDoubts (const Neighborhoods& neighborhoods,
            const std::vector<std::uint32_t>& wanted,
            const Depth& depth,
            const core::Execution& execution)
{
  return Walk (neighborhoods, depth, execution).run (wanted);
}
} // namespace tools
} // namespace pcl_normal_smoothing
