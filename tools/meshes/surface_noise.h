// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh_io.h"

#include <string>
#include <utility>
#include <vector>

namespace pcl_normal_smoothing
{
namespace tools
{
enum class NoiseType
{
  GN, //!< along the area-weighted normal of the vertex, by N(0, sigma)
  GR  //!< along a uniformly random direction, by N(0, sigma)
};

/** As options and tables call it. */
std::string
nameOf (NoiseType type);

/** All types, with their names. */
std::vector<std::pair<std::string, NoiseType>>
namedNoiseTypes ();

/** Moves the vertices by noise of standard deviation \a sigma, in the mesh's unit. For one seed the result is the same
  * on every machine; how a vertex moves does not depend on those after it. */
std::vector<Eigen::Vector3d>
noisyVertices (const Mesh& mesh, NoiseType type, double sigma, std::uint64_t seed);
} // namespace tools
} // namespace pcl_normal_smoothing
