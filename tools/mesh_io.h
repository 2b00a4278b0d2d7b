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

/** Reads a PLY, OFF, OBJ or STL file, told apart by the extension; larger faces are cut into triangles that share a corner.
  * \throw FileError where the file cannot be read or is no mesh */
Mesh
loadMesh (const std::string& path);

/** Writes a PLY file (text), as OutputFile does. \throw FileError */
void
saveMesh (const Mesh& mesh, const std::string& path);

/** Mean length of the edges, each counted once however many triangles it has. */
double
meanEdgeLength (const Mesh& mesh);

double
area (const Mesh& mesh);

/** Area-weighted normals of the vertices, of length 1; zero where a vertex has no triangle with an area. */
std::vector<Eigen::Vector3d>
vertexNormals (const Mesh& mesh);
} // namespace tools
} // namespace pcl_normal_smoothing
