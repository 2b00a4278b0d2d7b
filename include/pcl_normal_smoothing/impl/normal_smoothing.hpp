// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/impl/input_normals.hpp>
#include <pcl_normal_smoothing/impl/normal_smoothing_base.hpp>
#include <pcl_normal_smoothing/normal_smoothing.h>

namespace pcl_normal_smoothing
{
template <typename PointT>
void
NormalSmoothing<PointT>::applyFilter (PointCloud& output)
{
  const Outcome outcome = this->attempt (this->filter_name_, [&] {
    output = *this->input_;
    std::optional<VectorView> normals;
    if (this->options ().normals == NormalSource::INPUT)
      normals = chooseNormals (*this->input_, input_normals_);
    const SmoothingRun run = this->runSmoothing (this->filter_name_, positionsOf (*this->input_), normals,
                                                 *this->indices_, [this] { return this->input_; });
    auto* data = reinterpret_cast<std::uint8_t*> (output.data ());
    run.writePositions (positionLayout<PointT> (), data);
    if constexpr (pcl::traits::has_normal<PointT>::value)
      run.writeNormals (normalLayout<PointT> (), data);
  });
  this->settleOutput (outcome, *this->input_, output);
}
} // namespace pcl_normal_smoothing

#define PCL_INSTANTIATE_NormalSmoothing(T) template class PCL_EXPORTS pcl_normal_smoothing::NormalSmoothing<T>;
