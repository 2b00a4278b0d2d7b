// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/impl/surface_noise_estimation.hpp>

#include <pcl/impl/instantiate.hpp>

#include "point_types.h"

PCL_INSTANTIATE (SurfaceNoiseEstimation, PCL_NORMAL_SMOOTHING_POINT_TYPES)
