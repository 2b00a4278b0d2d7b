// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/hough_normal_estimation.h>
#include <pcl_normal_smoothing/impl/surface_normal_estimation.hpp>

#define PCL_INSTANTIATE_HoughNormalEstimation(T, NT) \
  template class PCL_EXPORTS pcl_normal_smoothing::HoughNormalEstimation<T, NT>;
