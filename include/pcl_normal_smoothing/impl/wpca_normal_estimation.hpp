// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/impl/surface_normal_estimation.hpp>
#include <pcl_normal_smoothing/wpca_normal_estimation.h>

#define PCL_INSTANTIATE_WPCANormalEstimation(T, NT) \
  template class PCL_EXPORTS pcl_normal_smoothing::WPCANormalEstimation<T, NT>;
