// SPDX-License-Identifier: BSD-3-Clause
#include "models/implicit_surface.h"

#include <algorithm>
#include <cmath>

namespace pcl_normal_smoothing::evaluation
{
namespace
{
constexpr int most_steps = 60;
constexpr double accuracy = 1e-12; // relative to a shape of size 1
} // namespace

Eigen::Vector3d
projectedTo (const ImplicitSurface& surface, Eigen::Vector3d point)
{
  for (int step = 0; step < most_steps; ++step) {
    const Eigen::Vector3d gradient = surface.gradient (point);
    const Eigen::Vector3d move = surface.value (point) / std::max (gradient.squaredNorm (), 1e-12) * gradient;
    point -= move;
    if (move.squaredNorm () < accuracy * accuracy)
      break;
  }
  return point;
}

double
distanceTo (const ImplicitSurface& surface, const Eigen::Vector3d& point)
{
  Eigen::Vector3d foot = projectedTo (surface, point);
  for (int step = 0; step < most_steps; ++step) {
    const Eigen::Vector3d normal = surface.gradient (foot).normalized (), way = point - foot;
    const Eigen::Vector3d slide = way - normal.dot (way) * normal;
    if (slide.norm () < 1e-9 * way.norm () + accuracy)
      break;
    foot = projectedTo (surface, foot + slide);
  }
  return (point - foot).norm ();
}

} // namespace pcl_normal_smoothing::evaluation
