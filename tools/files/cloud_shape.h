// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud_io.h"

#include <vector>

namespace pcl_normal_smoothing
{
namespace tools
{
/** The widest point and the most points that a cloud may have: PCL counts points in int. */
constexpr std::uint64_t max_point_bytes = 1u << 24, max_cloud_size = 0x7fffffff;

/** All that a file says of a cloud, its points apart. */
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

/** Makes \a file a cloud of that shape; its data are to be filled in. */
void
setShape (const CloudShape& shape, CloudFile& file);

} // namespace tools
} // namespace pcl_normal_smoothing
