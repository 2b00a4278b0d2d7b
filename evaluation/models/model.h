// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "meshes/mesh_io.h"

#include <functional>
#include <string>

namespace pcl_normal_smoothing::evaluation
{

/** Distance of a point to a surface, in the model's unit. Called from many threads. */
using DistanceFunction = std::function<double (const Eigen::Vector3d&)>;

/** What is sampled: a clean mesh and, if known, the surface on which its vertices lie. */
struct Model
{
  std::string name;
  /** Its origin and how it was changed, as readable text. */
  std::string source;
  tools::Mesh mesh;
  /** Empty if only the mesh is known. */
  DistanceFunction surface_distance;
};

} // namespace pcl_normal_smoothing::evaluation
