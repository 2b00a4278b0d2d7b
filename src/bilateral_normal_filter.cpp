// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/impl/bilateral_normal_filter.hpp>

#include <pcl/impl/instantiate.hpp>

#include "point_types.h"

PCL_INSTANTIATE (BilateralNormalFilter, PCL_NORMAL_SMOOTHING_POINT_TYPES)
