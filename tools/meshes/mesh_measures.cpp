// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_measures.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
/** A vector along the normal, of twice the triangle's area in length. */
Eigen::Vector3d
areaVector (const Mesh& mesh, const Mesh::Triangle& t)
{
  const Eigen::Vector3d& corner = mesh.vertices[t[0]];
  return (mesh.vertices[t[1]] - corner).cross (mesh.vertices[t[2]] - corner);
}
} // namespace

double
meanEdgeLength (const Mesh& mesh)
{
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const Mesh::Triangle& t : mesh.triangles)
    for (std::size_t c = 0; c < 3; ++c)
      edges.push_back (std::minmax ({t[c], t[(c + 1) % 3]}));
  std::sort (edges.begin (), edges.end ());
  edges.erase (std::unique (edges.begin (), edges.end ()), edges.end ());
  double sum = 0;
  for (const auto& [a, b] : edges)
    sum += (mesh.vertices[a] - mesh.vertices[b]).norm ();
  return edges.empty () ? 0 : sum / static_cast<double> (edges.size ());
}

double
area (const Mesh& mesh)
{
  double sum = 0;
  for (const Mesh::Triangle& t : mesh.triangles)
    sum += areaVector (mesh, t).norm () / 2;
  return sum;
}

std::vector<Eigen::Vector3d>
vertexNormals (const Mesh& mesh)
{
  std::vector<Eigen::Vector3d> normals (mesh.vertices.size (), Eigen::Vector3d::Zero ());
  for (const Mesh::Triangle& t : mesh.triangles)
    for (const std::uint32_t corner : t)
      normals[corner] += areaVector (mesh, t);
  for (Eigen::Vector3d& normal : normals)
    if (normal.norm () > 0)
      normal.normalize ();
  return normals;
}
} // namespace tools
} // namespace pcl_normal_smoothing
