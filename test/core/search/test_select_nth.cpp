// SPDX-License-Identifier: BSD-3-Clause
#include <core/search/select_nth.h>

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace
{
using namespace pcl_normal_smoothing::core;

struct Point
{
  float key;
  int number;
};

float
keyOf (const Point& point)
{
  return point.key;
}

/** Selects the n-th of some keys, and checks the order and completeness of all points. */
void
expectSelected (const std::vector<float>& keys, std::size_t n)
{
  std::vector<Point> points;
  for (const float key : keys)
    points.push_back ({key, static_cast<int> (points.size ())});
  selectNth (points.data (), points.data () + n, points.data () + points.size (), keyOf);

  std::vector<float> sorted = keys;
  std::sort (sorted.begin (), sorted.end ());
  EXPECT_EQ (points[n].key, sorted[n]);
  std::vector<bool> seen (keys.size ());
  for (std::size_t i = 0; i < points.size (); ++i) {
    EXPECT_TRUE (i < n ? points[i].key <= sorted[n] : points[i].key >= sorted[n]) << i << " of " << n;
    const auto number = static_cast<std::size_t> (points[i].number);
    EXPECT_EQ (points[i].key, keys[number]) << "a point was taken apart";
    EXPECT_FALSE (seen[number]) << "point " << number << " is there twice";
    seen[number] = true;
  }
}

void
expectAllSelected (const std::vector<float>& keys)
{
  for (const std::size_t n : {std::size_t (0), keys.size () / 7, keys.size () / 2, keys.size () - 1})
    expectSelected (keys, n);
}

TEST (SelectNth, PutsTheNthWhereASortWould)
{
  std::mt19937 generator (7);
  std::normal_distribution<float> normal;
  for (const std::size_t size : {1, 2, 31, 32, 33, 34, 100, 1000, 50000}) {
    std::vector<float> keys (size);
    for (float& key : keys)
      key = normal (generator);
    expectAllSelected (keys);
  }
}

TEST (SelectNth, EndsOnKeysInOrderAndOnTies)
{
  std::vector<float> keys (3000);
  for (std::size_t i = 0; i < keys.size (); ++i)
    keys[i] = static_cast<float> (i);
  expectAllSelected (keys);
  std::reverse (keys.begin (), keys.end ());
  expectAllSelected (keys);
  for (const std::size_t different : {1, 2, 3, 40}) {
    for (std::size_t i = 0; i < keys.size (); ++i)
      keys[i] = static_cast<float> (i * 7919 % different);
    expectAllSelected (keys);
  }
  keys.assign (keys.size (), 0.0f); // 0 and -0 are equal
  keys[5] = -0.0f;
  expectAllSelected (keys);
}
} // namespace
