// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/chain/point_update.h>
#include <pcl_normal_smoothing/input_checks.h>
#include <pcl_normal_smoothing/neighbor_graph.h>
#include <pcl_normal_smoothing/run_settings.h>

namespace pcl_normal_smoothing
{
/** How a filter finds neighbours. Features inherit these setters from pcl::Feature. */
template <typename PointT>
class SearchSettings : public RunSettings
{
public:
  using SearchPtr = typename pcl::search::Search<PointT>::Ptr;
  using SearchCloudConstPtr = typename pcl::PointCloud<PointT>::ConstPtr;

  /** The search object; it is given the input cloud, and called from many threads at once (setNumberOfThreads).
    * Default empty: this module's own search, which is exact and faster. */
  void
  setSearchMethod (const SearchPtr& search)
  {
    search_ = search;
  }

  SearchPtr
  getSearchMethod () const
  {
    return search_;
  }

  /** Number of neighbours, the point itself included. Default 0: not set. */
  void
  setKSearch (int k)
  {
    k_ = k;
  }

  int
  getKSearch () const
  {
    return k_;
  }

  /** Upper bound on the distance of neighbours, in the cloud's unit. Default 0: not set. */
  void
  setRadiusSearch (double radius)
  {
    radius_ = radius;
  }

  double
  getRadiusSearch () const
  {
    return radius_;
  }

protected:
  ~SearchSettings () = default;

  /** k if neither k nor a radius is set; 0: that is an error. */
  virtual int
  defaultK () const
  {
    return 0;
  }

  /** \throw core::Error if k is too small for this class; k 0: by radius */
  virtual void
  checkK (int) const
  {}

  /** Whether points in one place count as one. */
  virtual bool
  joinsCopies () const
  {
    return false;
  }

  core::NeighborQuery
  makeQuery () const
  {
    const int k = k_ == 0 && radius_ == 0 ? defaultK () : k_;
    core::NeighborQuery query = makeNeighborQuery (k, radius_, max_neighbor_distance_);
    checkK (k);
    query.distinct = joinsCopies ();
    return query;
  }

  /** The graph that was set, or one searched now.
    * \param[in] cloud given to the search object, if one is set
    * \throw core::Error if the settings or the cloud do not allow it */
  NeighborGraph::ConstPtr
  obtainGraph (const std::string& class_name,
               const core::Positions& positions,
               const std::function<SearchCloudConstPtr ()>& cloud,
               const core::Execution& execution) const;

  /** Searches the neighbours of moved nodes in the same way as before. If a graph was set, searches by k or the radius,
    * one of which must then be set.
    * \throw core::Error if neither is */
  core::SearchAgain
  makeSearchAgain (const NeighborGraph::ConstPtr& graph, const std::function<SearchCloudConstPtr ()>& cloud) const;

  SearchPtr search_;
  int k_ = 0;
  double radius_ = 0;
};
} // namespace pcl_normal_smoothing

#include <pcl_normal_smoothing/impl/search_settings.hpp>
