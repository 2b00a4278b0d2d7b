// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh_io.h"

#include <optional>

namespace pcl_normal_smoothing
{
namespace tools
{
/** Distances of points to a mesh, in its unit. */
struct SurfaceDistance
{
  double mean = 0;
  double rms = 0;
  double max = 0;
};

SurfaceDistance
distanceToMesh (const std::vector<Eigen::Vector3d>& points, const Mesh& mesh);

/** E_A of the paper: |A1 - A0| / A0, A1 the area of the mesh with its vertices at \a points. */
double
areaError (const std::vector<Eigen::Vector3d>& points, const Mesh& mesh);

/** E_k of the paper: the mean absolute difference of the surface variation among the \a k nearest, the point itself
  * included, searched anew in each cloud. Points without a surface variation in both clouds are left out; NaN where all
  * are. */
double
variationError (const std::vector<Eigen::Vector3d>& points, const std::vector<Eigen::Vector3d>& clean, unsigned k);

/** The mean angle, whatever the signs, of normals to those of the mesh's vertices, in degrees. Points where either has
  * no length are left out; NaN where all are. */
double
meanAngle (const std::vector<Eigen::Vector3d>& normals, const Mesh& mesh);

/** As above, to the \a expected normals. */
double
meanAngle (const std::vector<Eigen::Vector3d>& normals, const std::vector<Eigen::Vector3d>& expected);
} // namespace tools
} // namespace pcl_normal_smoothing
