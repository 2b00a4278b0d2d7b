// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/search/distinct_points.h>

#include <algorithm>
#include <limits>
#include <tuple>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
/** A set of hashes with false positives: one in 32 new hashes seems to be in it. */
class SeenHashes
{
public:
  explicit SeenHashes (std::size_t count)
  {
    while (bits_per_point * count >> (32 - shift_) != 0 && shift_ > 0)
      --shift_;
    words_.assign ((std::size_t {1} << (32 - shift_)) / word_size + 1, 0);
  }

  /** \return whether it was in the set before */
  bool
  insert (std::uint32_t hash)
  {
    const bool was_there = contains (hash);
    words_[(hash >> shift_) / word_size] |= bitOf (hash);
    return was_there;
  }

  bool
  contains (std::uint32_t hash) const
  {
    return (words_[(hash >> shift_) / word_size] & bitOf (hash)) != 0;
  }

private:
  static constexpr std::uint64_t bits_per_point = 32, word_size = 64;

  std::uint64_t
  bitOf (std::uint32_t hash) const
  {
    return std::uint64_t {1} << ((hash >> shift_) % word_size);
  }

  PaddedVector<std::uint64_t> words_;
  unsigned shift_ = 31;
};

struct HashedPoint
{
  std::uint32_t hash, point;

  bool
  operator<(const HashedPoint& other) const
  {
    return std::tie (hash, point) < std::tie (other.hash, other.point);
  }
};

/** Points that may share their place with another one: all that do, and a few more; sorted. */
std::vector<HashedPoint>
suspects (const Positions& cloud, const Elements& points, const Execution& execution)
{
  Elements hashes (points.size ());
  parallelFor (points.size (), execution, [&] (std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      hashes[i] = hashOf (cloud, points[i]);
  });
  SeenHashes seen (points.size ()), repeated (points.size ());
  for (const std::uint32_t hash : hashes)
    if (seen.insert (hash))
      repeated.insert (hash);
  std::vector<HashedPoint> found;
  for (std::size_t i = 0; i < points.size (); ++i)
    if (repeated.contains (hashes[i]))
      found.push_back ({hashes[i], points[i]});
  std::sort (found.begin (), found.end ());
  return found;
}
} // namespace

Copies
takeOutCopies (const Positions& cloud, const Execution& execution, Elements& points)
{
  const auto lieTogether = [&cloud] (std::uint32_t a, std::uint32_t b) {
    return cloud.base[a] == cloud.base[b] && cloud.offset[a] == cloud.offset[b];
  };
  Copies copies;
  std::vector<std::uint32_t> distinct; // those with the current hash
  std::uint32_t hash = 0;
  for (const HashedPoint& suspect : suspects (cloud, points, execution)) {
    if (suspect.hash != hash)
      distinct.clear ();
    hash = suspect.hash;
    const auto original = std::find_if (distinct.begin (), distinct.end (),
                                        [&] (std::uint32_t point) { return lieTogether (point, suspect.point); });
    if (original == distinct.end ())
      distinct.push_back (suspect.point);
    else {
      copies.points.push_back (suspect.point);
      copies.originals.push_back (*original);
    }
  }
  if (copies.points.empty ())
    return copies;
  std::vector<bool> is_copy (cloud.size ());
  for (const std::uint32_t point : copies.points)
    is_copy[point] = true;
  points.erase (std::remove_if (points.begin (), points.end (), [&] (std::uint32_t point) { return is_copy[point]; }),
                points.end ());
  return copies;
}
} // namespace core
} // namespace pcl_normal_smoothing
