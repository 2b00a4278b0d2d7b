// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <map>
#include <string>
#include <vector>

/** Methods of libraries, and LOP. They take points and the values of a setting, and return points in the same order.
  * Lengths that a setting gives in spacings must already be converted to the points' unit. A missing value throws
  * std::out_of_range. */
namespace pcl_normal_smoothing::evaluation
{

using WorkerPoints = std::vector<Eigen::Vector3d>;
using WorkerValues = std::map<std::string, double>;

/** Mean over all points of the mean distance to the 6 nearest others, the measure of CGAL's own defaults. */
double
averageSpacing (const WorkerPoints& points);

/** Reads "radius", "iterations" and "uniform". */
WorkerPoints
smoothWithWlop (const WorkerPoints& points, const WorkerValues& values);

/** Reads "neighbors". */
WorkerPoints
smoothWithJets (const WorkerPoints& points, const WorkerValues& values);

/** Reads "neighbors", "sharpness angle" and "iterations". The normals are by CGAL: PCA, oriented along the minimum
  * spanning tree. */
WorkerPoints
smoothBilaterally (const WorkerPoints& points, const WorkerValues& values);

/** Reads "radius" and "order". Points that PCL drops keep their positions. */
WorkerPoints
smoothWithMovingLeastSquares (const WorkerPoints& points, const WorkerValues& values);

/** Reads "h", "mu" and "iterations". */
WorkerPoints
smoothWithLop (const WorkerPoints& points, const WorkerValues& values);

} // namespace pcl_normal_smoothing::evaluation
