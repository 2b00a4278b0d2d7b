// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "models/model.h"

namespace pcl_normal_smoothing::evaluation
{

/** The smooth surface on which a function is zero. */
struct ImplicitSurface
{
  std::function<double (const Eigen::Vector3d&)> value;
  std::function<Eigen::Vector3d (const Eigen::Vector3d&)> gradient;
};

/** A point of the surface near \a point: Newton's method along the gradient. */
Eigen::Vector3d
projectedTo (const ImplicitSurface& surface, Eigen::Vector3d point);

/** The distance of \a point to the surface, found numerically: the foot point slides along the tangent plane until the
  * connecting line is normal to the surface. Reliable for points nearer than the radius of curvature, as in a noisy
  * cloud; farther off, the foot point found is not always the nearest. NaN if none is found. */
double
distanceTo (const ImplicitSurface& surface, const Eigen::Vector3d& point);

} // namespace pcl_normal_smoothing::evaluation
