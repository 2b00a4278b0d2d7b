// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/impl/input_normals.hpp>
#include <pcl_normal_smoothing/impl/search_settings.hpp>
#include <pcl_normal_smoothing/normal_smoothing.h>
#include <pcl_normal_smoothing/smoothing_run.h>

namespace pcl_normal_smoothing
{
template <typename PointT>
void
NormalSmoothing<PointT>::applyFilter (PointCloud& output)
{
  const Outcome outcome = this->attempt (this->filter_name_, [&] {
    used_options_ = {};
    output = *this->input_;
    const core::SmoothingOptions options = this->options ();
    std::optional<VectorView> normals;
    if (options.normals == NormalSource::INPUT)
      normals = chooseNormals (*this->input_, input_normals_);
    const auto input = [this] { return this->input_; };
    const core::Execution execution = this->execution ();

    SmoothingRun run (options, positionsOf (*this->input_), *this->indices_, execution.silent ());
    const auto graph = this->obtainGraph (this->filter_name_, run.cloud (), input, execution.part (0, 0.5));
    const auto search_again =
        options.update.search_interval > 0 ? this->makeSearchAgain (graph, input) : core::SearchAgain ();
    run.smooth (graph, normals, search_again, execution.part (0.5, 1));
    used_options_ = run.options ();
    auto* data = reinterpret_cast<std::uint8_t*> (output.data ());
    run.writePositions (positionLayout<PointT> (), data);
    if constexpr (pcl::traits::has_normal<PointT>::value)
      run.writeNormals (normalLayout<PointT> (), data);
  });
  settleOutput (outcome, *this->input_, output);
}
} // namespace pcl_normal_smoothing

#define PCL_INSTANTIATE_NormalSmoothing(T) template class PCL_EXPORTS pcl_normal_smoothing::NormalSmoothing<T>;
