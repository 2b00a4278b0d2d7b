// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <map>
#include <string>
#include <vector>

/** Methods of libraries, and LOP: points and the values of a setting in, points in the same order out. Those lengths
  * among the values that are in spacings must have been turned into the points' unit. A value that is missing throws
  * std::out_of_range. */
namespace pcl_normal_smoothing::evaluation
{

using WorkerPoints = std::vector<Eigen::Vector3d>;
using WorkerValues = std::map<std::string, double>;

/** Mean over all points of the mean distance to the 6 nearest others, as CGAL's own defaults use it. */
double
averageSpacing (const WorkerPoints& points);

/** Reads "radius", "iterations" and "uniform". */
WorkerPoints
smoothWithWlop (const WorkerPoints& points, const WorkerValues& values);

/** Reads "neighbors". */
WorkerPoints
smoothWithJets (const WorkerPoints& points, const WorkerValues& values);

/** Reads "neighbors", "sharpness angle" and "iterations". The normals are CGAL's, by PCA and oriented along the minimum
  * spanning tree. */
WorkerPoints
smoothBilaterally (const WorkerPoints& points, const WorkerValues& values);

/** Reads "radius" and "order". Where PCL drops a point, it stays as it was. */
WorkerPoints
smoothWithMovingLeastSquares (const WorkerPoints& points, const WorkerValues& values);

/** Reads "h", "mu" and "iterations". */
WorkerPoints
smoothWithLop (const WorkerPoints& points, const WorkerValues& values);

} // namespace pcl_normal_smoothing::evaluation
