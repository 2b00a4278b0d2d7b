// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "models/model.h"

namespace pcl_normal_smoothing::evaluation
{

/** The smooth surface where a function vanishes. */
struct ImplicitSurface
{
  std::function<double (const Eigen::Vector3d&)> value;
  std::function<Eigen::Vector3d (const Eigen::Vector3d&)> gradient;
};

/** A point of the surface near \a point: Newton's method along the gradient. */
Eigen::Vector3d
projectedTo (const ImplicitSurface& surface, Eigen::Vector3d point);

/** The distance of \a point to the surface, numerically: the foot point slides along the tangent plane until the
  * connection is along the normal. For points nearer than the radius of curvature, as those of a noisy cloud are; the
  * distance to some point of the surface, not always the nearest, beyond. NaN where that finds none. */
double
distanceTo (const ImplicitSurface& surface, const Eigen::Vector3d& point);

} // namespace pcl_normal_smoothing::evaluation
