// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/bilateral_normal_filter.h>
#include <pcl_normal_smoothing/impl/input_normals.hpp>
#include <pcl_normal_smoothing/impl/search_settings.hpp>

#include <utility>

namespace pcl_normal_smoothing
{
template <typename PointT>
core::Vectors
BilateralNormalFilter<PointT>::run (NeighborGraph::ConstPtr& graph)
{
  core::check (options_);
  const VectorView input_normals = chooseNormals (*this->input_, input_normals_);
  const core::Execution execution = this->execution ();
  const core::Positions cloud = readPositions (positionsOf (*this->input_), execution.silent ());
  graph = this->obtainGraph (
      this->filter_name_, cloud, [this] { return this->input_; }, execution.part (0, 0.7));
  core::Vectors normals = readNormals (input_normals, graph->order (), execution.silent ());
  core::filterNormals (*graph, gather (cloud, graph->order (), execution.silent ()), options_, execution.part (0.7, 1),
                       normals);
  return normals;
}

template <typename PointT>
void
BilateralNormalFilter<PointT>::applyFilter (PointCloud& output)
{
  const Outcome outcome = this->attempt (this->filter_name_, [&] {
    output = *this->input_;
    if constexpr (pcl::traits::has_normal<PointT>::value) {
      NeighborGraph::ConstPtr graph;
      const std::vector<bool> selected = selectPoints (*this->indices_, output.size ());
      const core::Vectors normals = run (graph);
      writeNormals (normals, graph->order (), selected, normalLayout<PointT> (),
                    reinterpret_cast<std::uint8_t*> (output.data ()), this->execution ().silent ());
    }
    else
      throw core::Error ("the point type has no normal to write: call filterNormals, or use a type with normals");
  });
  this->settleOutput (outcome, *this->input_, output);
}

template <typename PointT>
void
BilateralNormalFilter<PointT>::filterNormals (pcl::PointCloud<pcl::Normal>& normals)
{
  pcl::PointCloud<pcl::Normal> result;
  const Outcome outcome = this->attempt (this->filter_name_, [&] {
    if (!this->initCompute ())
      this->failWithoutInput ();
    if (!input_normals_)
      throw core::Error ("filterNormals filters the normals of setInputNormals: call it first");
    result = *input_normals_;
    NeighborGraph::ConstPtr graph;
    const std::vector<bool> selected = selectPoints (*this->indices_, this->input_->size ());
    const core::Vectors filtered = run (graph);
    writeNormals (filtered, graph->order (), selected, normalLayout<pcl::Normal> (),
                  reinterpret_cast<std::uint8_t*> (result.data ()), this->execution ().silent ());
  });
  if (outcome == Outcome::DONE)
    normals = std::move (result);
  else if (outcome == Outcome::CANCELLED)
    normals = *input_normals_;
  else if (&normals != input_normals_.get ())
    normals.clear ();
  this->deinitCompute ();
}
} // namespace pcl_normal_smoothing

#define PCL_INSTANTIATE_BilateralNormalFilter(T) \
  template class PCL_EXPORTS pcl_normal_smoothing::BilateralNormalFilter<T>;
