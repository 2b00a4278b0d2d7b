// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/error.h>
#include <pcl_normal_smoothing/input_checks.h>
#include <pcl_normal_smoothing/neighbor_graph.h>

#include <pcl/common/point_tests.h>
#include <pcl/search/organized.h>

#include <algorithm>
#include <cmath>

namespace pcl_normal_smoothing
{
template <typename PointT>
PointSearch<PointT>
pointSearch (const typename pcl::search::Search<PointT>::Ptr& search,
             const typename pcl::PointCloud<PointT>::ConstPtr& cloud,
             const core::NeighborQuery& query)
{
  // A user's is_dense is often wrong, and the cloud may have changed since: pass the finite points explicitly.
  auto finite = pcl::make_shared<pcl::Indices> ();
  for (std::size_t i = 0; i < cloud->size (); ++i)
    if (pcl::isXYZFinite ((*cloud)[i]))
      finite->push_back (static_cast<pcl::index_t> (i));
  const bool all = finite->size () == cloud->size ();
  // At most the number of points: k may be absurdly large, and vectors of that size are allocated.
  const std::size_t k = std::min<std::size_t> (query.k, finite->size ());
  search->setInputCloud (cloud, all ? pcl::IndicesConstPtr () : finite);
  const auto* organized = dynamic_cast<const pcl::search::OrganizedNeighbor<PointT>*> (search.get ());
  if (organized && (cloud->width < 2 || cloud->height < 2 || !organized->isValid ())) // it would search without end
    throw core::Error ("pcl::search::OrganizedNeighbor finds no camera that can have seen this cloud (" +
                       std::to_string (cloud->width) + " x " + std::to_string (cloud->height) +
                       " points): set another search object, or none");

  return [search, query, k] (const PointT& point, std::vector<std::uint32_t>& neighbors) {
    pcl::Indices found (k);
    std::vector<float> sq_dists (k);
    const int count = query.k > 0 ? search->nearestKSearch (point, static_cast<int> (k), found, sq_dists)
                                  : search->radiusSearch (point, query.radius, found, sq_dists);
    neighbors.clear ();
    // The vectors may be longer than what was found, and some searches find points exactly at the radius, others not.
    const std::size_t room = std::min (found.size (), sq_dists.size ());
    for (std::size_t j = 0; j < std::min (room, static_cast<std::size_t> (std::max (0, count))); ++j)
      if (!(sq_dists[j] >= query.radius * query.radius))
        neighbors.push_back (static_cast<std::uint32_t> (found[j]));
  };
}

template <typename PointT>
NeighborGraph::Search
graphSearch (const typename pcl::search::Search<PointT>::Ptr& search,
             const typename pcl::PointCloud<PointT>::ConstPtr& cloud,
             const core::NeighborQuery& query)
{
  return [cloud, find = pointSearch<PointT> (search, cloud, query)] (std::uint32_t index,
                                                                     std::vector<std::uint32_t>& neighbors) {
    find ((*cloud)[index], neighbors);
  };
}

template <typename PointT>
NeighborGraph::ConstPtr
buildNeighborGraph (const typename pcl::PointCloud<PointT>::ConstPtr& cloud,
                    int k,
                    double radius,
                    const typename pcl::search::Search<PointT>::Ptr& search,
                    unsigned int threads)
{
  if (!cloud)
    throw core::Error ("no cloud is given whose neighbours could be searched");
  const core::NeighborQuery query =
      makeNeighborQuery (k, k > 0 ? 0 : radius, k > 0 ? radius : 0,
                         {"the argument k", "the argument radius", "the argument radius"});
  const core::Execution execution (threads);
  const core::Positions positions = readPositions (positionsOf (*cloud), execution);
  if (search)
    return NeighborGraph::build (positions, graphSearch<PointT> (search, cloud, query), execution);
  return NeighborGraph::build (positions, query.inUnit (positions.unit), execution);
}
} // namespace pcl_normal_smoothing
