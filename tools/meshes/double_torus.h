// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh_io.h"

#include <functional>

namespace pcl_normal_smoothing
{
namespace tools
{
/** A smooth closed surface where a function vanishes; below 0 inside. */
struct DoubleTorus
{
  std::function<double (const Eigen::Vector3d&)> value;
  std::function<Eigen::Vector3d (const Eigen::Vector3d&)> gradient;
  /** Half the sides of a box around it. */
  Eigen::Vector3d box;
};

/** (x^2 (1 - x^2) - y^2)^2 + (0.8 z)^2 = 0.12^2: the tube is flat where it turns, two to five spacings of 4,350 points
  * thick. */
DoubleTorus
figureOfEight ();

/** Two round tori side by side, of radii 0.55 and 0.25, joined smoothly where they meet: the tube is ten spacings of
  * 4,350 points thick. */
DoubleTorus
joinedTori ();

/** A closed triangle mesh of genus 2 that samples the surface evenly: every vertex lies on it.
  * \param[in] vertices how many, at least 1000
  * \throw core::Error where that cannot be made */
Mesh
makeDoubleTorus (const DoubleTorus& torus, std::size_t vertices);
} // namespace tools
} // namespace pcl_normal_smoothing
