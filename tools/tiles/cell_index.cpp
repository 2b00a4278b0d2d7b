// SPDX-License-Identifier: BSD-3-Clause
#include "cell_index.h"

#include <limits>

namespace pcl_normal_smoothing
{
namespace tools
{
CellIndex::CellIndex (const std::vector<Cell>& cells)
{
  while (leaves_ < cells.size ())
    leaves_ *= 2;
  boxes_.resize (2 * leaves_ - 1);
  loaded_.resize (2 * leaves_ - 1);
  for (std::size_t i = 0; i < leaves_; ++i) {
    if (i < cells.size ())
      boxes_[leaves_ - 1 + i] = cells[i].box;
    loaded_[leaves_ - 1 + i] = i >= cells.size ();
  }
  for (std::size_t node = leaves_ - 1; node-- > 0;) {
    boxes_[node] = boxes_[2 * node + 1].merged (boxes_[2 * node + 2]);
    loaded_[node] = loaded_[2 * node + 1] && loaded_[2 * node + 2];
  }
}

void
CellIndex::setLoaded (std::size_t cell)
{
  std::size_t node = leaves_ - 1 + cell;
  loaded_[node] = 1;
  while (node > 0) {
    node = (node - 1) / 2;
    loaded_[node] = loaded_[2 * node + 1] && loaded_[2 * node + 2];
  }
}

bool
CellIndex::isNear (const Eigen::Vector3d& place, double distance) const
{
  std::size_t nodes[64], count = 1; // at most one per level, and a sibling
  nodes[0] = 0;
  while (count > 0) {
    const std::size_t node = nodes[--count];
    if (loaded_[node] || boxes_[node].exteriorDistance (place) > distance)
      continue;
    if (node >= leaves_ - 1)
      return true;
    nodes[count++] = 2 * node + 2;
    nodes[count++] = 2 * node + 1;
  }
  return false;
}

double
CellIndex::distanceFrom (const Eigen::AlignedBox3d& box) const
{
  double nearest = std::numeric_limits<double>::infinity ();
  std::size_t nodes[64], count = 1;
  nodes[0] = 0;
  while (count > 0) {
    const std::size_t node = nodes[--count];
    const double distance = loaded_[node] ? nearest : boxes_[node].exteriorDistance (box);
    if (distance >= nearest)
      continue;
    if (node >= leaves_ - 1) {
      nearest = distance;
      continue;
    }
    nodes[count++] = 2 * node + 2;
    nodes[count++] = 2 * node + 1;
  }
  return nearest;
}

void
CellIndex::forEachNear (const Eigen::AlignedBox3d& box, double distance, const Use& use) const
{
  std::vector<std::size_t> nodes {0};
  while (!nodes.empty ()) {
    const std::size_t node = nodes.back ();
    nodes.pop_back ();
    if (loaded_[node])
      continue;
    const double from_here = boxes_[node].exteriorDistance (box);
    if (from_here > distance)
      continue;
    if (node >= leaves_ - 1)
      use (static_cast<std::uint32_t> (node - (leaves_ - 1)), from_here);
    else
      nodes.insert (nodes.end (), {2 * node + 2, 2 * node + 1});
  }
}
} // namespace tools
} // namespace pcl_normal_smoothing
