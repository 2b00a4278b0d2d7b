// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../shapes.h"

#include <pcl/search/brute_force.h>
#include <pcl/search/kdtree.h>
#include <pcl/search/octree.h>
#include <pcl/search/organized.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

namespace test_support
{
/** Search objects such as a user may set. */
template <typename PointT>
std::vector<typename pcl::search::Search<PointT>::Ptr>
userSearches ()
{
  return {std::make_shared<pcl::search::KdTree<PointT>> (), std::make_shared<pcl::search::KdTree<PointT>> (false),
          std::make_shared<pcl::search::BruteForce<PointT>> (), std::make_shared<pcl::search::Octree<PointT>> (0.1)};
}

/** A search for organised clouds of cameras. */
template <typename PointT>
typename pcl::search::Search<PointT>::Ptr
organizedSearch ()
{
  return std::make_shared<pcl::search::OrganizedNeighbor<PointT>> ();
}

/** A wave seen by a camera with a focal length of 30 pixels: 24 x 20 points, row by row. */
inline Vectors
cameraView ()
{
  Vectors points;
  for (int v = 0; v < 20; ++v)
    for (int u = 0; u < 24; ++u) {
      const float x = static_cast<float> (u) - 11.5f, y = static_cast<float> (v) - 9.5f;
      const float depth = 2 + 0.1f * std::sin (0.3f * x) * std::cos (0.2f * y) +
                          static_cast<float> (0.002 * gaussianNoise (190, points.size ()));
      points.emplace_back (x * depth / 30, y * depth / 30, depth);
    }
  return points;
}

template <typename PointT>
class ThrowingSearch : public pcl::search::KdTree<PointT>
{
public:
  int
  nearestKSearch (const PointT&, int, pcl::Indices&, std::vector<float>&) const override
  {
    throw std::runtime_error ("the index is corrupt");
  }
};

/** Throws after a number of queries. */
template <typename PointT>
class TiringSearch : public pcl::search::KdTree<PointT>
{
public:
  explicit TiringSearch (int queries) : queries_ (queries) {}

  int
  nearestKSearch (const PointT& point, int k, pcl::Indices& indices, std::vector<float>& sq_dists) const override
  {
    if (queries_-- <= 0)
      throw std::runtime_error ("the index is tired");
    return pcl::search::KdTree<PointT>::nearestKSearch (point, k, indices, sq_dists);
  }

private:
  mutable std::atomic<int> queries_;
};

/** Finds at most a given number of points and, as old searches do, leaves the vectors at the size they had. */
template <typename PointT>
class ShortSearch : public pcl::search::KdTree<PointT>
{
public:
  explicit ShortSearch (int most) : most_ (most) {}

  int
  nearestKSearch (const PointT& point, int, pcl::Indices& indices, std::vector<float>& sq_dists) const override
  {
    pcl::Indices found;
    std::vector<float> found_sq_dists;
    const int count = pcl::search::KdTree<PointT>::nearestKSearch (point, most_, found, found_sq_dists);
    std::copy (found.begin (), found.end (), indices.begin ());
    std::copy (found_sq_dists.begin (), found_sq_dists.end (), sq_dists.begin ());
    return count;
  }

private:
  int most_;
};

/** Returns an index that does not exist in the cloud of 300 points. */
template <typename PointT>
class WrongSearch : public pcl::search::KdTree<PointT>
{
public:
  int
  nearestKSearch (const PointT&, int k, pcl::Indices& indices, std::vector<float>& sq_dists) const override
  {
    indices.assign (static_cast<std::size_t> (k), 300);
    sq_dists.assign (static_cast<std::size_t> (k), 0);
    return k;
  }
};
} // namespace test_support
