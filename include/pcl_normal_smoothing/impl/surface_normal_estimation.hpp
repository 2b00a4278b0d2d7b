// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/chain/surface_estimation.h>
#include <pcl_normal_smoothing/core/error.h>
#include <pcl_normal_smoothing/input_checks.h>
#include <pcl_normal_smoothing/surface_normal_estimation.h>

namespace pcl_normal_smoothing
{
template <typename PointInT, typename PointOutT>
bool
SurfaceNormalEstimation<PointInT, PointOutT>::initCompute ()
{
  const Outcome outcome = attempt (this->feature_name_, [this] {
    if (!pcl::PCLBase<PointInT>::initCompute ())
      failWithoutInput ();
    if (this->input_->empty ())
      throw core::Error ("the input cloud is empty: give it points");
    selectPoints (*this->indices_, this->input_->size ());
    if (neighbor_graph_ && this->surface_)
      throw core::Error ("a neighbour graph and a search surface are both set: a graph is of the input cloud alone");
    if (!neighbor_graph_)
      makeNeighborQuery (this->k_, this->search_radius_, max_neighbor_distance_);
    makeEstimator ();
  });
  if (outcome != Outcome::DONE)
    return false;
  if (!this->surface_) {
    this->fake_surface_ = true;
    this->surface_ = this->input_;
  }
  return true;
}

template <typename PointInT, typename PointOutT>
void
SurfaceNormalEstimation<PointInT, PointOutT>::computeFeature (PointCloudOut& output)
{
  const Outcome outcome = attempt (this->feature_name_, [&] {
    const std::vector<core::LocalSurface> surfaces = estimate ();
    Eigen::Vector3f view_point;
    getViewPoint (view_point.x (), view_point.y (), view_point.z ());
    output.is_dense = true;
    for (std::size_t i = 0; i < surfaces.size (); ++i) {
      store (surfaces[i], view_point - (*this->input_)[(*this->indices_)[i]].getVector3fMap (), output[i]);
      output.is_dense = output.is_dense && std::isfinite (surfaces[i].variation);
    }
  });
  if (outcome != Outcome::DONE)
    emptyCloud (output);
}

template <typename PointInT, typename PointOutT>
void
SurfaceNormalEstimation<PointInT, PointOutT>::store (const core::LocalSurface& surface,
                                                     const Eigen::Vector3f& to_view_point,
                                                     PointOutT& output) const
{
  const float sign = surface.normal.dot (to_view_point) < 0 ? -1.0f : 1.0f;
  output.getNormalVector3fMap () = sign * surface.normal;
  output.curvature = surface.variation;
}

template <typename PointInT, typename PointOutT>
std::vector<core::LocalSurface>
SurfaceNormalEstimation<PointInT, PointOutT>::estimate ()
{
  const core::SurfaceEstimator estimator = makeEstimator ();
  const bool whole_cloud = this->fake_surface_ && this->fake_indices_;
  return neighbor_graph_ || whole_cloud ? estimateOverGraph (estimator) : estimateByQueries (estimator);
}

template <typename PointInT, typename PointOutT>
std::vector<core::LocalSurface>
SurfaceNormalEstimation<PointInT, PointOutT>::estimateOverGraph (const core::SurfaceEstimator& estimator)
{
  const core::Execution run = execution ();
  const core::Positions cloud = readPositions (positionsOf (*this->input_), run.silent ());
  NeighborGraph::ConstPtr graph;
  if (neighbor_graph_) {
    graph = fittingGraph (cloud);
    checkPointCount (this->feature_name_, graph->size (), 0);
  }
  else {
    const core::NeighborQuery query = makeNeighborQuery (this->k_, this->search_radius_, max_neighbor_distance_);
    graph = this->tree_ ? NeighborGraph::build (cloud, graphSearch<PointInT> (this->tree_, this->input_, query),
                                                run.part (0, 0.8))
                        : NeighborGraph::build (cloud, query.inUnit (cloud.unit), run.part (0, 0.8));
    checkPointCount (this->feature_name_, graph->size (), query.k);
  }
  const auto of_nodes =
      core::estimateSurfaces (*graph, gather (cloud, graph->order (), run.silent ()), estimator, run.part (0.8, 1));
  std::vector<core::LocalSurface> of_points (cloud.size (), core::LocalSurface::invalid ());
  for (std::size_t node = 0; node < of_nodes.size (); ++node)
    of_points[graph->order ()[node]] = of_nodes[node];
  std::vector<core::LocalSurface> surfaces;
  for (const pcl::index_t index : *this->indices_)
    surfaces.push_back (of_points[static_cast<std::size_t> (index)]);
  return surfaces;
}

template <typename PointInT, typename PointOutT>
std::vector<core::LocalSurface>
SurfaceNormalEstimation<PointInT, PointOutT>::estimateByQueries (const core::SurfaceEstimator& estimator)
{
  const core::NeighborQuery query = makeNeighborQuery (this->k_, this->search_radius_, max_neighbor_distance_);
  const core::Execution run = execution ();
  const core::Positions surface = readPositions (positionsOf (*this->surface_), run.silent ());
  checkPointCount (this->feature_name_, core::finiteElements (surface, run.silent ()).size (), query.k);
  const core::Positions cloud = readPositions (positionsOf (*this->input_), surface.unit, run.silent ());
  const core::Elements queries (this->indices_->begin (), this->indices_->end ());
  const core::Positions places = gather (cloud, queries, run.silent ());
  if (!this->tree_)
    return core::querySurfaces (surface, places, query.inUnit (surface.unit), estimator, run);

  const auto search = pointSearch<PointInT> (this->tree_, this->surface_, query);
  return core::querySurfaces (
      surface, places,
      [&] (std::size_t i, std::vector<std::uint32_t>& found) { search ((*this->input_)[(*this->indices_)[i]], found); },
      estimator, run);
}
} // namespace pcl_normal_smoothing
