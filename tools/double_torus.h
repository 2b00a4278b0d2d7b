// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh_io.h"

namespace pcl_normal_smoothing
{
namespace tools
{
/** The surface (x^2 (1 - x^2) - y^2)^2 + (0.8 z)^2 = 0.12^2 as an implicit function: 0 on it, below 0 inside. */
double
doubleTorusValue (const Eigen::Vector3d& point);

Eigen::Vector3d
doubleTorusGradient (const Eigen::Vector3d& point);

/** A closed triangle mesh of genus 2 that samples the smooth surface
  * (x^2 (1 - x^2) - y^2)^2 + (0.8 z)^2 = 0.12^2 evenly: every vertex lies on it.
  * \param[in] vertices how many, at least 1000
  * \throw core::Error where that cannot be made */
Mesh
makeDoubleTorus (std::size_t vertices);
} // namespace tools
} // namespace pcl_normal_smoothing
