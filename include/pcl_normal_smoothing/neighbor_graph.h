// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/run_settings.h>
#include <pcl_normal_smoothing/vector_layout.h>

#include <pcl/search/search.h>

namespace pcl_normal_smoothing
{
/** Finds the neighbours of any point: \a neighbors is set to indices in the searched cloud. */
template <typename PointT>
using PointSearch = std::function<void (const PointT& point, std::vector<std::uint32_t>& neighbors)>;

/** Wraps a search object and one kind of query.
  * \param[in] search is set to search \a cloud, or its finite points if it holds others; if the result is called from
  * many threads, so is the search
  * \param[in] query k, a radius, or k limited by a radius */
template <typename PointT>
PointSearch<PointT>
pointSearch (const typename pcl::search::Search<PointT>::Ptr& search,
             const typename pcl::PointCloud<PointT>::ConstPtr& cloud,
             const core::NeighborQuery& query);

/** The same for the points of the cloud itself. */
template <typename PointT>
NeighborGraph::Search
graphSearch (const typename pcl::search::Search<PointT>::Ptr& search,
             const typename pcl::PointCloud<PointT>::ConstPtr& cloud,
             const core::NeighborQuery& query);

/** Searches the neighbours of all finite points of a cloud once, for all the classes of a chain (setNeighborGraph).
  * \param[in] k number of neighbours, the point itself included; 0: by radius
  * \param[in] radius upper bound on the distance, excluded; 0: k alone. Both: the k nearest within the radius.
  * \param[in] search a search object, called from many threads at once; empty: this module's own search, exact and
  * faster
  * \param[in] threads 0: all cores
  * \throw core::Error if the cloud is null, if k and radius are both 0, or if one is negative, not finite or beyond the
  * range of float */
template <typename PointT>
NeighborGraph::ConstPtr
buildNeighborGraph (const typename pcl::PointCloud<PointT>::ConstPtr& cloud,
                    int k,
                    double radius = 0,
                    const typename pcl::search::Search<PointT>::Ptr& search = nullptr,
                    unsigned int threads = 0);
} // namespace pcl_normal_smoothing

#include <pcl_normal_smoothing/impl/neighbor_graph.hpp>
