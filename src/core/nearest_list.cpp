// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/nearest_list.h>

#include <algorithm>
#include <cmath>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
// From here on a heap costs less than keeping the list sorted.
constexpr std::size_t sorted_capacity = 64;
} // namespace

void
NearestList::reset (std::size_t capacity, float radius)
{
  neighbors_.clear ();
  capacity_ = capacity;
  constexpr auto last_rank = std::numeric_limits<std::uint32_t>::max ();
  // Closer than the radius, not at it: no rank is below 0.
  bound_ = std::isfinite (radius) ? Neighbor {radius * radius, 0, 0}
                                  : Neighbor {std::numeric_limits<float>::infinity (), last_rank, 0};
  if (capacity == 0)
    bound_ = {-1.0f, 0, 0};
}

void
NearestList::place (const Neighbor& neighbor)
{
  if (capacity_ > sorted_capacity) {
    if (neighbors_.size () == capacity_) {
      std::pop_heap (neighbors_.begin (), neighbors_.end ());
      neighbors_.back () = neighbor;
    }
    else
      neighbors_.push_back (neighbor);
    std::push_heap (neighbors_.begin (), neighbors_.end ());
    if (neighbors_.size () == capacity_)
      bound_ = neighbors_.front ();
    return;
  }
  if (neighbors_.size () < capacity_)
    neighbors_.push_back (neighbor);
  std::size_t i = neighbors_.size () - 1;
  for (; i > 0 && neighbor < neighbors_[i - 1]; --i)
    neighbors_[i] = neighbors_[i - 1];
  neighbors_[i] = neighbor;
  if (neighbors_.size () == capacity_)
    bound_ = neighbors_.back ();
}

const std::vector<Neighbor>&
NearestList::sorted ()
{
  if (capacity_ > sorted_capacity)
    std::sort (neighbors_.begin (), neighbors_.end ());
  return neighbors_;
}
} // namespace core
} // namespace pcl_normal_smoothing
