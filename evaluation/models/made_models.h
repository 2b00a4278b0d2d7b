// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "models/model.h"

namespace pcl_normal_smoothing::evaluation
{

/** Names of the shapes that are made in code:
  * double_torus  smooth, genus 2, evenly sampled; 4,350 points as the paper's. Exact distance: numeric
  * double_torus_round   two round tori, joined, as many points. Exact distance: numeric
  * csg_part      an extruded L with a fillet, a rounded corner and a bore; sharp edges. Exact distance: closed form
  * plate         about two spacings thick, sharp edges. Exact distance: closed form
  * organic       smooth bumps on a ball, the spacing varying by a factor of 4. Exact distance: numeric
  * two_sheets    two parallel squares as close as their points, open (the paper's Fig. 10). Exact distance: closed form
  * two_sheets_apart   the same at twice the distance
  * cube          sharp edges and corners alone. Exact distance: closed form
  * sphere        constant curvature, nearly even. Exact distance: closed form */
const std::vector<std::string>&
madeModelNames ();

/** \throw core::Error for any other name */
Model
makeModel (const std::string& name);

} // namespace pcl_normal_smoothing::evaluation
