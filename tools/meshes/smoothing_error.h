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

/** E_A of the paper: |A1 - A0| / A0, where A0 is the area of the mesh and A1 that with its vertices at \a points. */
double
areaError (const std::vector<Eigen::Vector3d>& points, const Mesh& mesh);

/** E_k of the paper: the mean absolute difference of the surface variations over the \a k nearest points, the point
  * itself included, searched in each cloud separately. Points without a surface variation in one of the clouds are left
  * out; NaN if all are. */
double
variationError (const std::vector<Eigen::Vector3d>& points, const std::vector<Eigen::Vector3d>& clean, unsigned k);

/** The mean angle between normals and those of the mesh's vertices, regardless of sign, in degrees. Points with a
  * normal of length zero are left out; NaN if all are. */
double
meanAngle (const std::vector<Eigen::Vector3d>& normals, const Mesh& mesh);

/** As above, for the \a expected normals. */
double
meanAngle (const std::vector<Eigen::Vector3d>& normals, const std::vector<Eigen::Vector3d>& expected);
} // namespace tools
} // namespace pcl_normal_smoothing
