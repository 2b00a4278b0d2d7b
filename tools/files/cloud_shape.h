// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud_io.h"

#include <vector>

namespace pcl_normal_smoothing
{
namespace tools
{
/** Limits on the bytes of a point and the points of a cloud: PCL counts points in int. */
constexpr std::uint64_t max_point_bytes = 1u << 24, max_cloud_size = 0x7fffffff;

/** Everything that a file says about a cloud, except its points. */
struct CloudShape
{
  std::vector<pcl::PCLPointField> fields;
  std::size_t point_step = 0;
  std::uint64_t width = 0, height = 1;
  Eigen::Vector4f origin = Eigen::Vector4f::Zero ();
  Eigen::Quaternionf orientation = Eigen::Quaternionf::Identity ();
  /** Faces of a PLY mesh, which a cloud does not keep. */
  std::uint64_t faces = 0;

  std::uint64_t
  size () const
  {
    return width * height;
  }
};

CloudShape
shapeOf (const CloudFile& file);

/** Gives the cloud of \a file that shape; its data are left to the caller. */
void
setShape (const CloudShape& shape, CloudFile& file);

} // namespace tools
} // namespace pcl_normal_smoothing
