// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "models/model.h"
#include "models/profile.h"

namespace pcl_normal_smoothing::evaluation
{

/** The closed mesh of the body over \a profile between z = 0 and z = \a height, with outward normals. The vertices are
  * about \a spacing apart, all on the exact surface; every edge of the body has vertices along it. */
tools::Mesh
extrude (const Profile& profile, double height, double spacing);

/** The exact distance of \a point to the surface. */
double
distanceToExtrusion (const Profile& profile, double height, const Eigen::Vector3d& point);

} // namespace pcl_normal_smoothing::evaluation
