// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/error.h>
#include <pcl_normal_smoothing/vector_layout.h>

#include <pcl/point_types.h>

namespace pcl_normal_smoothing
{
/** The source of a filter's normals: \a normals if set, or else the points' own.
  * \throw core::Error if there are none, or not one for every point */
template <typename PointT>
VectorView
chooseNormals (const pcl::PointCloud<PointT>& cloud, const pcl::PointCloud<pcl::Normal>::ConstPtr& normals)
{
  if (normals && normals->size () != cloud.size ())
    throw core::Error ("setInputNormals has " + std::to_string (normals->size ()) + " normals, the input cloud " +
                       std::to_string (cloud.size ()) + " points: give one normal for every point");
  if (normals)
    return normalsOf (*normals);
  if constexpr (pcl::traits::has_normal<PointT>::value)
    return normalsOf (cloud);
  else
    throw core::Error ("the point type has no normals: call setInputNormals");
}
} // namespace pcl_normal_smoothing
