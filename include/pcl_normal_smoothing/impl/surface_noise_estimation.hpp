// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/error.h>
#include <pcl_normal_smoothing/impl/search_settings.hpp>
#include <pcl_normal_smoothing/surface_noise_estimation.h>

#include <limits>

namespace pcl_normal_smoothing
{
template <typename PointT>
bool
SurfaceNoiseEstimation<PointT>::compute ()
{
  estimate_ = {};
  const Outcome outcome = this->attempt ("SurfaceNoiseEstimation", [this] {
    if (!this->initCompute ())
      throw core::Error ("no input cloud is set: call setInputCloud");
    core::Positions cloud = readPositions (positionsOf (*this->input_));
    const std::vector<bool> selected = selectPoints (*this->indices_, cloud.size ());
    for (std::size_t i = 0; i < cloud.size (); ++i)
      if (!selected[i])
        cloud.base[i].setConstant (std::numeric_limits<float>::quiet_NaN ());
    const auto graph = this->obtainGraph (
        "SurfaceNoiseEstimation", cloud, [this] { return this->input_; }, this->execution ().part (0, 0.9));
    estimate_ = core::estimateNoise (*graph, gather (cloud, graph->order ()), this->execution ().part (0.9, 1))
                    .inCloudUnit (cloud.unit);
    this->deinitCompute ();
  });
  return outcome == Outcome::DONE;
}
} // namespace pcl_normal_smoothing

#define PCL_INSTANTIATE_SurfaceNoiseEstimation(T) \
  template class PCL_EXPORTS pcl_normal_smoothing::SurfaceNoiseEstimation<T>;
