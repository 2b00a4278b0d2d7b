// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "meshes/mesh_io.h"

#include <functional>
#include <string>

namespace pcl_normal_smoothing::evaluation
{

/** Distance of a point to a surface, in the model's unit. Called from many threads. */
using DistanceFunction = std::function<double (const Eigen::Vector3d&)>;

/** What is sampled: a clean mesh, and the surface that its vertices lie on where that is known. */
struct Model
{
  std::string name;
  /** Where it is from, and what was done to it, for people. */
  std::string source;
  tools::Mesh mesh;
  /** Empty where nothing but the mesh is known. */
  DistanceFunction surface_distance;
};

} // namespace pcl_normal_smoothing::evaluation
