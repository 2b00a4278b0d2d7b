// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CGAL/Simple_cartesian.h>

#include <Eigen/Core>

namespace pcl_normal_smoothing::evaluation
{

using Kernel = CGAL::Simple_cartesian<double>;

inline Kernel::Point_3
toCgal (const Eigen::Vector3d& p)
{
  return {p.x (), p.y (), p.z ()};
}

} // namespace pcl_normal_smoothing::evaluation
