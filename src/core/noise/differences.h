// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl_normal_smoothing
{
namespace core
{
/** p_j - p_i from a node i to its nearest neighbours j, itself first. */
using Differences = std::vector<Eigen::Vector3d>;

/** The node and so many of its nearest tell whether it lies in a plane, or on a line. */
constexpr std::size_t nearest_count = 8;

/** Of the \a count nearest. \param[in] differences at least as many */
Eigen::Vector3d
meanOfNearest (const Differences& differences, std::size_t count = nearest_count);

/** How points lie about their mean. */
struct PrincipalAxes
{
  /** Ascending. */
  Eigen::Vector3d variances;
  /** Along which the first is: of the plane through the points. */
  Eigen::Vector3d normal;
  /** Along which the last is: of the line through the points. */
  Eigen::Vector3d direction;

  /** The points lie along a line: across it they vary by less than that \a share of their variance along it. */
  bool
  areLine (double share) const
  {
    return variances[1] < share * variances[2];
  }
};

/** Of the \a count nearest. \param[in] differences at least as many */
PrincipalAxes
axesOfNearest (const Differences& differences, std::size_t count = nearest_count);

/** Sarle's coefficient of the heights over the plane through all: 1 where there are two, 1/3 of many that are normally
  * distributed; 0 where all lie in the plane. */
double
bimodality (const Differences& differences);

/** The median distance of the last of the nearest_count nearest; 0 of none. */
float
medianReach (const std::vector<Differences>& differences);
} // namespace core
} // namespace pcl_normal_smoothing
