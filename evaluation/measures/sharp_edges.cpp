// SPDX-License-Identifier: BSD-3-Clause
#include "measures/sharp_edges.h"

#include "measures/cgal_point.h"
#include "meshes/mesh_edges.h"

#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>

#include <Eigen/Geometry>

#include <cmath>

namespace pcl_normal_smoothing::evaluation
{
namespace
{
using Segments = std::vector<Kernel::Segment_3>;
using Primitive = CGAL::AABB_segment_primitive<Kernel, Segments::const_iterator>;

Eigen::Vector3d
normalOf (const tools::Mesh& mesh, std::uint32_t triangle)
{
  const auto& [a, b, c] = mesh.triangles[triangle];
  return (mesh.vertices[b] - mesh.vertices[a]).cross (mesh.vertices[c] - mesh.vertices[a]).normalized ();
}
} // namespace

std::vector<std::uint32_t>
verticesNearSharpEdges (const tools::Mesh& mesh, double degrees, double reach)
{
  Segments segments;
  for (const tools::MeshEdge& edge : tools::edgesOf (mesh))
    if (normalOf (mesh, edge.left).dot (normalOf (mesh, edge.right)) < std::cos (degrees * M_PI / 180))
      segments.emplace_back (toCgal (mesh.vertices[edge.a]), toCgal (mesh.vertices[edge.b]));
  std::vector<std::uint32_t> near;
  if (segments.empty ())
    return near;
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree (segments.begin (), segments.end ());
  tree.accelerate_distance_queries ();
  for (std::uint32_t i = 0; i < mesh.vertices.size (); ++i)
    if (tree.squared_distance (toCgal (mesh.vertices[i])) <= reach * reach)
      near.push_back (i);
  return near;
}

} // namespace pcl_normal_smoothing::evaluation
