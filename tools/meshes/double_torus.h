// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh_io.h"

#include <functional>

namespace pcl_normal_smoothing
{
namespace tools
{
/** A smooth closed surface: the zeros of a function that is negative inside. */
struct DoubleTorus
{
  std::function<double (const Eigen::Vector3d&)> value;
  std::function<Eigen::Vector3d (const Eigen::Vector3d&)> gradient;
  /** Half the side lengths of a box around it, centred on the origin. */
  Eigen::Vector3d box;
};

/** (x^2 (1 - x^2) - y^2)^2 + (0.8 z)^2 = 0.12^2: the tube is flat where it turns, and with 4,350 points two to five
  * spacings thick. */
DoubleTorus
figureOfEight ();

/** Two round tori side by side, of radii 0.55 and 0.25, joined smoothly where they meet: with 4,350 points, the tube is
  * ten spacings thick. */
DoubleTorus
joinedTori ();

/** A closed triangle mesh of genus 2 that samples the surface evenly: every vertex lies on it.
  * \param[in] vertices their number, at least 1000
  * \throw core::Error if such a mesh cannot be made */
Mesh
makeDoubleTorus (const DoubleTorus& torus, std::size_t vertices);
} // namespace tools
} // namespace pcl_normal_smoothing
