// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/impl/input_normals.hpp>
#include <pcl_normal_smoothing/impl/search_settings.hpp>
#include <pcl_normal_smoothing/input_checks.h>
#include <pcl_normal_smoothing/normal_guided_point_update.h>

namespace pcl_normal_smoothing
{
template <typename PointT>
void
NormalGuidedPointUpdate<PointT>::applyFilter (PointCloud& output)
{
  const Outcome outcome = this->attempt (this->filter_name_, [&] {
    output = *this->input_;
    core::PointUpdateOptions options = options_;
    options.max_displacement = floatLength (max_displacement_, "the maximal displacement", "setMaxDisplacement");
    core::check (options);
    const std::vector<bool> selected = selectPoints (*this->indices_, output.size ());
    const VectorView input_normals = chooseNormals (*this->input_, input_normals_);
    const core::Execution execution = this->execution ();
    const auto input = [this] { return this->input_; };

    const core::Positions cloud = readPositions (positionsOf (*this->input_), execution.silent ());
    const auto graph = this->obtainGraph (this->filter_name_, cloud, input, execution.part (0, 0.7));
    core::Positions nodes = gather (cloud, graph->order (), execution.silent ());
    const core::Vectors start = core::startOf (nodes);
    const core::SearchAgain search_again =
        options.search_interval > 0 ? this->makeSearchAgain (graph, input) : core::SearchAgain ();
    const core::Vectors normals = readNormals (input_normals, graph->order (), execution.silent ());
    core::updatePoints (graph, normals, options.inUnit (nodes.unit), search_again, execution.part (0.7, 1), nodes);
    writeDisplacements (displacements (start, nodes), nodes.unit, graph->order (), selected, positionLayout<PointT> (),
                        reinterpret_cast<std::uint8_t*> (output.data ()), execution.silent ());
  });
  this->settleOutput (outcome, *this->input_, output);
}
} // namespace pcl_normal_smoothing

#define PCL_INSTANTIATE_NormalGuidedPointUpdate(T) \
  template class PCL_EXPORTS pcl_normal_smoothing::NormalGuidedPointUpdate<T>;
