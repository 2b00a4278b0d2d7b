// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl_normal_smoothing::evaluation
{

struct LopParameters
{
  /** Support radius, in the unit of the points, above 0. */
  double h = 0;
  /** Weight of the repulsion, from 0 to below 0.5. */
  double mu = 0.25;
  /** Of which the first only averages. */
  int iterations = 10;
};

/** Moves all points by the locally optimal projection of Lipman, Cohen-Or, Levin and Tal-Ezer, "Parameterization-free
  * Projection for Geometry Reconstruction", SIGGRAPH 2007, with the repulsion eta (r) = 1 / (3 r^3) of that paper.
  *
  * The projected set begins as the points themselves. Neighbors beyond h, where the weight has fallen to exp (-16),
  * count nothing; nor do those at no distance, which have no direction. A point without neighbors stays.
  * \return point i is what became of point i */
std::vector<Eigen::Vector3d>
locallyOptimalProjection (const std::vector<Eigen::Vector3d>& points, const LopParameters& parameters);

} // namespace pcl_normal_smoothing::evaluation
