// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl_normal_smoothing
{
namespace tools
{
/** A triangle mesh, its vertices in the order of the file. */
struct Mesh
{
  using Triangle = std::array<std::uint32_t, 3>;

  std::vector<Eigen::Vector3d> vertices;
  std::vector<Triangle> triangles;
};

/** Reads a PLY, OFF, OBJ or STL file, told apart by the extension; larger faces are split into triangles that share
  * one corner.
  * \throw FileError if the file cannot be read or is not a mesh */
Mesh
loadMesh (const std::string& path);

/** Writes a PLY file (text) by means of OutputFile. \throw FileError */
void
saveMesh (const Mesh& mesh, const std::string& path);
} // namespace tools
} // namespace pcl_normal_smoothing
