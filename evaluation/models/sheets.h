// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "models/model.h"

namespace pcl_normal_smoothing::evaluation
{

/** Two squares of side 1 at z = 0 and z = \a gap, each of \a side x \a side vertices; normals down and up. */
tools::Mesh
makeSheets (std::uint32_t side, double gap);

/** The exact distance of \a point to the two squares. */
double
distanceToSheets (double gap, const Eigen::Vector3d& point);

} // namespace pcl_normal_smoothing::evaluation
