// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

namespace pcl_normal_smoothing::benchmarks
{
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

enum class Order
{
  RANDOM,
  ALONG_RINGS // as a rotating scanner records it
};

/** A torus of radii 1 and .4, with noise of .2 mean spacings along its normals; identical on every call. */
Cloud::Ptr
makeTorus (std::size_t size, Order order);

/** Mean distance of the points to the torus. */
double
meanDistance (const Cloud& cloud);

/** Mean spacing of the points of such a torus: the side of a square with the mean area per point. */
double
spacingOf (std::size_t size);
} // namespace pcl_normal_smoothing::benchmarks
