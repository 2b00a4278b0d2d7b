// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/error.h>
#include <pcl_normal_smoothing/impl/search_settings.hpp>
#include <pcl_normal_smoothing/surface_noise_estimation.h>

#include <pcl/common/point_tests.h>

namespace pcl_normal_smoothing
{
template <typename PointT>
typename pcl::PointCloud<PointT>::ConstPtr
SurfaceNoiseEstimation<PointT>::indexedPoints () const
{
  const std::vector<bool> selected = selectPoints (*this->indices_, this->input_->size ());
  std::size_t left_out = 0; // points that are not finite do not count anyway
  for (std::size_t i = 0; i < selected.size (); ++i)
    left_out += !selected[i] && pcl::isXYZFinite ((*this->input_)[i]);
  if (left_out == 0)
    return this->input_;
  if (this->neighbor_graph_)
    throw core::Error ("setIndices leaves out " + std::to_string (left_out) + " of " +
                       std::to_string (selected.size ()) +
                       " points, but the neighbour graph is of all: call setNeighborGraph (nullptr), or set the "
                       "indexed points as a cloud of their own with a graph of it");
  auto points = pcl::make_shared<pcl::PointCloud<PointT>> ();
  for (std::size_t i = 0; i < selected.size (); ++i)
    if (selected[i])
      points->push_back ((*this->input_)[i]);
  return points;
}

template <typename PointT>
bool
SurfaceNoiseEstimation<PointT>::compute ()
{
  estimate_ = {};
  const Outcome outcome = this->attempt ("SurfaceNoiseEstimation", [this] {
    if (!this->initCompute ())
      this->failWithoutInput ();
    const typename pcl::PointCloud<PointT>::ConstPtr points = indexedPoints ();
    const core::Execution execution = this->execution ();
    const core::Positions cloud = readPositions (positionsOf (*points), execution.silent ());
    const auto graph = this->obtainGraph (
        "SurfaceNoiseEstimation", cloud, [&] { return points; }, execution.part (0, 0.9));
    const core::Positions nodes = gather (cloud, graph->order (), execution.silent ());
    estimate_ = core::estimateNoise (*graph, nodes, execution.part (0.9, 1)).inCloudUnit (cloud.unit);
    this->deinitCompute ();
  });
  return outcome == Outcome::DONE;
}
} // namespace pcl_normal_smoothing

#define PCL_INSTANTIATE_SurfaceNoiseEstimation(T) \
  template class PCL_EXPORTS pcl_normal_smoothing::SurfaceNoiseEstimation<T>;
