// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/impl/hough_normal_estimation.hpp>

#include <pcl/impl/instantiate.hpp>

#include "point_types.h"

PCL_INSTANTIATE_PRODUCT (HoughNormalEstimation, (PCL_NORMAL_SMOOTHING_POINT_TYPES) (PCL_NORMAL_SMOOTHING_NORMAL_TYPES))
