// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh_io.h"

namespace pcl_normal_smoothing
{
namespace tools
{
/** The surface (x^2 (1 - x^2) - y^2)^2 + (0.8 z)^2 = thickness^2: smooth, of genus 2. */
struct DoubleTorus
{
  /** 0.05 to 0.2: with less the mesh has hardly any points around the tube, with a quarter the holes close. */
  double thickness = 0.12;

  /** 0 on the surface, below 0 inside. */
  double
  valueAt (const Eigen::Vector3d& point) const;

  Eigen::Vector3d
  gradientAt (const Eigen::Vector3d& point) const;
};

/** A closed triangle mesh that samples the surface evenly: every vertex lies on it.
  * \param[in] vertices how many, at least 1000
  * \throw core::Error where that cannot be made */
Mesh
makeDoubleTorus (const DoubleTorus& torus, std::size_t vertices);
} // namespace tools
} // namespace pcl_normal_smoothing
