// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "models/implicit_surface.h"

namespace pcl_normal_smoothing::evaluation
{

/** The unit sphere: an icosahedron whose triangles are split into four, \a times times. */
tools::Mesh
makeSphere (int times);

/** Smooth bumps and dents on the unit sphere: the radius is a function of the direction. */
const ImplicitSurface&
bumpyBall ();

/** The bumpy ball with vertices as unevenly spread as those of a scan: four times as far apart at the bottom as at the
  * top, and randomly shifted. */
tools::Mesh
makeUnevenBall (int times);

} // namespace pcl_normal_smoothing::evaluation
