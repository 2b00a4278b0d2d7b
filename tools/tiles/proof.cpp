// SPDX-License-Identifier: BSD-3-Clause
#include "proof.h"

#include "region.h"

#include <cmath>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
/** Walks hop by hop, and looks at every row once. */
class Walk
{
public:
  Walk (const Neighborhoods& neighborhoods, const Depth& depth)
  : all_ (neighborhoods)
  , depth_ (depth)
  , seen_ (neighborhoods.searched.size ())
  , gaps_ (neighborhoods.plan.cells.size (), -1)
  {}

  std::vector<Doubt>
  run (const std::vector<std::uint32_t>& wanted)
  {
    if (depth_.rows < 0 || all_.cells.allLoaded ())
      return {};
    visit (wanted);
    std::size_t begin = 0;
    int hop = 0;
    for (; hop <= depth_.rows; ++hop)
      begin = look (all_.used, begin, depth_.rows - hop, hop < depth_.rows);
    // A separated row is made of rows as they were searched, of all nodes so far and of those around.
    begin = 0;
    for (int farther = 0; farther <= depth_.separation; ++farther)
      begin = look (all_.searched, begin, 0, farther < depth_.separation);
    return std::move (doubts_);
  }

private:
  /** Looks at the rows of the nodes from \a begin on, and goes on to what they name. \return where those begin */
  std::size_t
  look (const core::NeighborGraph& graph, std::size_t begin, int hops_left, bool go_on)
  {
    const std::size_t end = nodes_.size ();
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t node = nodes_[i];
      if ((seen_[node] & CHECKED) == 0 && !isCertain (node))
        doubts_.push_back ({node, hops_left + std::max (depth_.separation, 0)});
      seen_[node] |= CHECKED;
      if (!go_on)
        continue;
      const core::Row row = graph.row (node);
      for (std::size_t j = 0; j < row.size (); ++j)
        visit (row[j]);
    }
    return end;
  }

  void
  visit (std::uint32_t node)
  {
    if (seen_[node] == 0)
      nodes_.push_back (node);
    seen_[node] |= VISITED;
  }

  void
  visit (const std::vector<std::uint32_t>& nodes)
  {
    for (const std::uint32_t node : nodes)
      visit (node);
  }

  bool
  isCertain (std::uint32_t node)
  {
    const double radius = all_.rowRadius (node);
    double& gap = gaps_[all_.cellOf (node)];
    if (gap < 0)
      gap = all_.cells.distanceFrom (all_.plan.cells[all_.cellOf (node)].box);
    return radius < gap || !all_.cells.isNear (all_.placeOf (node), radius);
  }

  enum Seen : std::uint8_t
  {
    VISITED = 1,
    CHECKED = 2
  };

  const Neighborhoods& all_;
  const Depth& depth_;
  std::vector<std::uint8_t> seen_;
  std::vector<double> gaps_; // from every cell to the nearest that is not loaded; below 0: not known yet
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
  // Distances are compared in float, and positions are sums of two floats: no more is lost than this, nor where squares vanish.
  constexpr double relative = 1e-5, tiny = 1e-17;
  const double lost = std::ldexp (static_cast<double> (nodes.base[node].lpNorm<Eigen::Infinity> ()), -40) + tiny;
  const core::Row row = searched.row (node);
  double radius = query.radius;
  if (query.k > 0 && row.size () >= query.k)
    radius = std::sqrt (static_cast<double> (core::squaredLength (nodes.difference (node, row[row.size () - 1]))));
  return plan.unit * (radius * (1 + relative) + lost);
}

std::vector<Doubt>
findDoubts (const Neighborhoods& neighborhoods, const std::vector<std::uint32_t>& wanted, const Depth& depth)
{
  return Walk (neighborhoods, depth).run (wanted);
}
} // namespace tools
} // namespace pcl_normal_smoothing
