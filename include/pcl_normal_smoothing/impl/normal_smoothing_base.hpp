// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/impl/search_settings.hpp>
#include <pcl_normal_smoothing/normal_smoothing_base.h>

namespace pcl_normal_smoothing
{
template <typename PointT>
SmoothingRun
NormalSmoothingBase<PointT>::runSmoothing (
    const std::string& class_name,
    const VectorView& positions,
    const std::optional<VectorView>& normals,
    const pcl::Indices& indices,
    const std::function<typename SearchSettings<PointT>::SearchCloudConstPtr ()>& cloud)
{
  const core::SmoothingOptions options = this->options ();
  const core::Execution execution = this->execution ();
  SmoothingRun run (options, positions, indices, execution.silent ());
  const auto graph = this->obtainGraph (class_name, run.cloud (), cloud, execution.part (0, 0.5));
  const auto search_again =
      options.update.search_interval > 0 ? this->makeSearchAgain (graph, cloud) : core::SearchAgain ();
  run.smooth (graph, normals, search_again, execution.part (0.5, 1));
  used_options_ = run.options ();
  return run;
}
} // namespace pcl_normal_smoothing
