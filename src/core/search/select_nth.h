// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <iterator>

namespace pcl_normal_smoothing
{
namespace core
{
namespace detail
{
constexpr std::ptrdiff_t max_pivot_sample = 1024;

/** A pivot that nearly always leaves the n-th point on the smaller side of a partition: the corresponding key of a
  * sample, and some ranks further. */
template <typename Point, typename Key>
auto
choosePivot (const Point* first, const Point* nth, const Point* last, const Key& key)
{
  std::array<decltype (key (*first)), max_pivot_sample> sample;
  const std::ptrdiff_t size = last - first, sample_size = std::clamp<std::ptrdiff_t> (size / 32, 5, max_pivot_sample);
  for (std::ptrdiff_t i = 0; i < sample_size; ++i)
    sample[static_cast<std::size_t> (i)] = key (first[i * size / sample_size]);
  const double at = static_cast<double> (nth - first) / static_cast<double> (size);
  const double slack = 0.5 * std::sqrt (static_cast<double> (sample_size));
  const double rank = at * static_cast<double> (sample_size) + (at < 0.5 ? slack : -slack);
  const auto pivot = sample.begin () + std::clamp<std::ptrdiff_t> (std::lround (rank), 0, sample_size - 1);
  std::nth_element (sample.begin (), pivot, sample.begin () + sample_size);
  return *pivot;
}

/** Unlike std::swap, does not copy member by member: loads of partly written points would stall. */
template <typename Point>
void
swapWhole (Point& a, Point& b)
{
  struct Bytes
  {
    unsigned char bytes[sizeof (Point)];
  } of_a, of_b;
  std::memcpy (&of_a, &a, sizeof (Point));
  std::memcpy (&of_b, &b, sizeof (Point));
  std::memcpy (static_cast<void*> (&a), &of_b, sizeof (Point));
  std::memcpy (static_cast<void*> (&b), &of_a, sizeof (Point));
}

/** Moves the \a wanted points to the front, without unpredictable branches on data. */
template <typename Point, typename Wanted>
Point*
partitionPoints (Point* first, Point* last, const Wanted& wanted)
{
  for (Point* point = first; point != last; ++point) {
    const bool to_front = wanted (*point);
    swapWhole (*point, *first);
    first += to_front;
  }
  return first;
}
} // namespace detail

/** std::nth_element by a numeric key, in a half to a quarter of the time: no branches are mispredicted, and pivots
  * come from a sample (after Floyd and Rivest, Communications of the ACM 18, 1975). */
template <typename Point, typename Key>
void
selectNth (Point* first, Point* nth, Point* last, const Key& key)
{
  constexpr std::ptrdiff_t few = 32;
  while (last - first > few) {
    const auto pivot = detail::choosePivot (first, nth, last, key);
    Point* const middle = detail::partitionPoints (first, last, [&] (const Point& p) { return key (p) < pivot; });
    if (nth < middle)
      last = middle;
    else if (middle > first)
      first = middle;
    else { // the pivot is the smallest key: many may equal it
      first = detail::partitionPoints (first, last, [&] (const Point& p) { return !(pivot < key (p)); });
      if (nth < first)
        return;
    }
  }
  std::nth_element (first, nth, last, [&] (const Point& a, const Point& b) { return key (a) < key (b); });
}
} // namespace core
} // namespace pcl_normal_smoothing
