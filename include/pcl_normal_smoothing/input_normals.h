// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

namespace pcl_normal_smoothing
{
/** Normals given separately from a filter's input, for point types without normals. */
class InputNormals
{
public:
  using NormalsConstPtr = pcl::PointCloud<pcl::Normal>::ConstPtr;

  /** Normals for the points of the input, one per point, used instead of the points' own. Default none. */
  void
  setInputNormals (const NormalsConstPtr& normals)
  {
    input_normals_ = normals;
  }

  NormalsConstPtr
  getInputNormals () const
  {
    return input_normals_;
  }

protected:
  ~InputNormals () = default;

  NormalsConstPtr input_normals_;
};
} // namespace pcl_normal_smoothing
