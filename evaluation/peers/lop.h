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
  /** Number of iterations; the first one only averages. */
  int iterations = 10;
};

/** Moves all points by the locally optimal projection of Lipman, Cohen-Or, Levin and Tal-Ezer, "Parameterization-free
  * Projection for Geometry Reconstruction", SIGGRAPH 2007, with the repulsion eta (r) = 1 / (3 r^3) of that paper.
  *
  * The projected set starts as a copy of the points. Neighbours beyond h, where the weight has fallen to exp (-16), are
  * ignored; so are those at distance zero, which have no direction. A point without neighbours stays where it is.
  * \return the new position of every point, in the same order */
std::vector<Eigen::Vector3d>
locallyOptimalProjection (const std::vector<Eigen::Vector3d>& points, const LopParameters& parameters);

} // namespace pcl_normal_smoothing::evaluation
