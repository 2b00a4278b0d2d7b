// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/error.h>
#include <pcl_normal_smoothing/search_settings.h>

namespace pcl_normal_smoothing
{
/** Gives a user's search object back as it was: when this goes, it searches the same cloud as before, even after an
  * error. */
template <typename PointT>
class SearchBorrowed
{
public:
  explicit SearchBorrowed (const typename pcl::search::Search<PointT>::Ptr& search)
  : search_ (search), cloud_ (search->getInputCloud ()), indices_ (search->getIndices ())
  {}

  SearchBorrowed (const SearchBorrowed&) = delete;
  SearchBorrowed&
  operator= (const SearchBorrowed&) = delete;

  ~SearchBorrowed ()
  {
    try {
      if (cloud_)
        search_->setInputCloud (cloud_, indices_);
    }
    catch (const std::exception&) { // it threw before, and that is the error to report
    }
  }

private:
  typename pcl::search::Search<PointT>::Ptr search_;
  typename pcl::PointCloud<PointT>::ConstPtr cloud_;
  pcl::IndicesConstPtr indices_;
};

template <typename PointT>
NeighborGraph::ConstPtr
SearchSettings<PointT>::obtainGraph (const std::string& class_name,
                                     const core::Positions& positions,
                                     const std::function<SearchCloudConstPtr ()>& cloud,
                                     const core::Execution& execution) const
{
  if (neighbor_graph_) {
    const NeighborGraph::ConstPtr graph = fittingGraph (positions, joinsCopies ());
    checkPointCount (class_name, graph->finiteCount (), 0);
    return graph;
  }
  const core::NeighborQuery query = makeQuery ();
  const NeighborGraph::ConstPtr graph =
      search_
          ? NeighborGraph::build (positions, graphSearch<PointT> (search_, cloud (), query), execution, query.distinct)
          : NeighborGraph::build (positions, query.inUnit (positions.unit), execution);
  checkPointCount (class_name, graph->finiteCount (), query.k);
  return graph;
}

template <typename PointT>
core::SearchAgain
SearchSettings<PointT>::makeSearchAgain (const NeighborGraph::ConstPtr& graph,
                                         const std::function<SearchCloudConstPtr ()>& cloud) const
{
  if (neighbor_graph_ && k_ == 0 && radius_ == 0) // the graph does not say how it was searched
    throw core::Error ("a neighbour graph and a search interval are set, but neither k nor a radius to search anew by: "
                       "call setKSearch or setRadiusSearch, or setSearchInterval (0)");
  const core::NeighborQuery query = makeQuery ();
  const core::Execution quiet (threads_);
  if (!search_)
    return [=] (const core::Positions& nodes) { return graph->rebuild (nodes, query.inUnit (nodes.unit), quiet); };
  return [=, search = search_] (const core::Positions& nodes) {
    auto moved = pcl::make_shared<pcl::PointCloud<PointT>> (*cloud ());
    for (std::size_t node = 0; node < nodes.size (); ++node) {
      const Eigen::Vector3f position = nodes.inCloudUnit (node);
      PointT& point = (*moved)[graph->order ()[node]];
      point.x = position.x ();
      point.y = position.y ();
      point.z = position.z ();
    }
    const SearchBorrowed<PointT> borrowed (search);
    return graph->rebuild (nodes, graphSearch<PointT> (search, moved, query), quiet);
  };
}
} // namespace pcl_normal_smoothing
