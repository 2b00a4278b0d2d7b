// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "files/cloud_io.h"

#include <Eigen/Core>

#include <vector>

namespace pcl_normal_smoothing
{
namespace tools
{
/** The distance from a finite number to the next float away from 0: how coarse float is there. */
double
floatStep (double number);

/** A cloud of the fields x y z, in one row.
  * \param[in] resolution the fields are double where the steps of float are larger than this, otherwise float
  * \throw core::Error if a coordinate is not finite */
CloudFile
cloudOfPoints (const std::vector<Eigen::Vector3d>& points, double resolution);
} // namespace tools
} // namespace pcl_normal_smoothing
