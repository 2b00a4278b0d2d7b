// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_types.h>

// The point types for which the classes are compiled; for others, include the headers in impl.
#define PCL_NORMAL_SMOOTHING_POINT_TYPES_WITH_NORMALS (pcl::PointNormal) (pcl::PointXYZINormal) (pcl::PointXYZRGBNormal)
#define PCL_NORMAL_SMOOTHING_POINT_TYPES \
  (pcl::PointXYZ) (pcl::PointXYZI) (pcl::PointXYZRGB) (pcl::PointXYZRGBA) PCL_NORMAL_SMOOTHING_POINT_TYPES_WITH_NORMALS
// The output point types of the estimators.
#define PCL_NORMAL_SMOOTHING_NORMAL_TYPES (pcl::Normal) PCL_NORMAL_SMOOTHING_POINT_TYPES_WITH_NORMALS
