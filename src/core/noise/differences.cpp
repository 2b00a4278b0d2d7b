// SPDX-License-Identifier: BSD-3-Clause
#include "differences.h"

#include "../quantile.h"

#include <Eigen/Eigenvalues>

namespace pcl_normal_smoothing
{
namespace core
{
Eigen::Vector3d
meanOfNearest (const Differences& differences, std::size_t count)
{
  Eigen::Vector3d mean = Eigen::Vector3d::Zero ();
  for (std::size_t j = 0; j < count; ++j)
    mean += differences[j] / static_cast<double> (count);
  return mean;
}

PrincipalAxes
axesOfNearest (const Differences& differences, std::size_t count)
{
  const Eigen::Vector3d mean = meanOfNearest (differences, count);
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero ();
  for (std::size_t j = 0; j < count; ++j)
    covariance += (differences[j] - mean) * (differences[j] - mean).transpose () / static_cast<double> (count);
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect (covariance);
  return {solver.eigenvalues (), solver.eigenvectors ().col (0), solver.eigenvectors ().col (2)};
}

double
bimodality (const Differences& differences)
{
  const std::size_t count = differences.size ();
  const Eigen::Vector3d normal = axesOfNearest (differences, count).normal, mean = meanOfNearest (differences, count);
  double squares = 0, cubes = 0, fourths = 0;
  for (const Eigen::Vector3d& difference : differences) {
    const double height = normal.dot (difference - mean);
    squares += height * height;
    cubes += height * height * height;
    fourths += height * height * height * height;
  }
  const auto n = static_cast<double> (count);
  return squares > 0 ? (n * cubes * cubes / squares + squares * squares) / (n * fourths) : 0;
}

float
medianReach (const std::vector<Differences>& differences)
{
  std::vector<float> reaches;
  for (const Differences& of_node : differences)
    reaches.push_back (static_cast<float> (of_node[nearest_count - 1].norm ()));
  return quantile (reaches, .5);
}
} // namespace core
} // namespace pcl_normal_smoothing
