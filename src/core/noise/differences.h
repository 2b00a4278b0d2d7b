// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl_normal_smoothing
{
namespace core
{
/** p_j - p_i from a node i to its nearest neighbours j, the node itself first. */
using Differences = std::vector<Eigen::Vector3d>;

/** Number of nearest points, the node included, that show whether it lies in a plane or on a line. */
constexpr std::size_t nearest_count = 8;

/** Mean of the \a count nearest. \param[in] differences at least as many */
Eigen::Vector3d
meanOfNearest (const Differences& differences, std::size_t count = nearest_count);

/** Spread of points about their mean. */
struct PrincipalAxes
{
  /** Ascending. */
  Eigen::Vector3d variances;
  /** Direction of the first variance: normal of the plane through the points. */
  Eigen::Vector3d normal;
  /** Direction of the last variance: of the line through the points. */
  Eigen::Vector3d direction;

  /** Whether the points lie along a line: their variance across it is below that \a share of the variance along it. */
  bool
  areLine (double share) const
  {
    return variances[1] < share * variances[2];
  }
};

/** Principal axes of the \a count nearest. \param[in] differences at least as many */
PrincipalAxes
axesOfNearest (const Differences& differences, std::size_t count = nearest_count);

/** Sarle's bimodality coefficient of the heights over the plane through all points: 1 for just two heights, 1/3 for
  * many normally distributed ones; 0 if all points lie in the plane. */
double
bimodality (const Differences& differences);

/** Median distance of the last of the nearest_count nearest; 0 for no nodes. */
float
medianReach (const std::vector<Differences>& differences);
} // namespace core
} // namespace pcl_normal_smoothing
