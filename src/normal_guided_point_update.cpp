// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/impl/normal_guided_point_update.hpp>

#include <pcl/impl/instantiate.hpp>

#include "point_types.h"

PCL_INSTANTIATE (NormalGuidedPointUpdate, PCL_NORMAL_SMOOTHING_POINT_TYPES)
