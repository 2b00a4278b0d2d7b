// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_edges.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
using VertexPair = std::pair<std::uint32_t, std::uint32_t>;

/** The corner of a triangle that is not on the edge. */
std::uint32_t
opposite (const Mesh::Triangle& t, const MeshEdge& edge)
{
  return *std::find_if (t.begin (), t.end (),
                        [&] (std::uint32_t corner) { return corner != edge.a && corner != edge.b; });
}

double
angleAt (const Mesh& mesh, std::uint32_t corner, const MeshEdge& edge)
{
  const Eigen::Vector3d u = mesh.vertices[edge.a] - mesh.vertices[corner],
                        v = mesh.vertices[edge.b] - mesh.vertices[corner];
  return std::atan2 (u.cross (v).norm (), u.dot (v));
}

double
lengthOf (const Mesh& mesh, const MeshEdge& edge)
{
  return (mesh.vertices[edge.a] - mesh.vertices[edge.b]).norm ();
}
} // namespace

std::vector<MeshEdge>
edgesOf (const Mesh& mesh)
{
  std::vector<std::tuple<std::uint32_t, std::uint32_t, bool, std::uint32_t>> sides; // lower, higher, reversed; triangle
  for (std::uint32_t t = 0; t < mesh.triangles.size (); ++t)
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t from = mesh.triangles[t][c], to = mesh.triangles[t][(c + 1) % 3];
      sides.emplace_back (std::min (from, to), std::max (from, to), from > to, t);
    }
  std::sort (sides.begin (), sides.end ());
  std::vector<MeshEdge> edges;
  for (std::size_t i = 0; i < sides.size ();) {
    const auto [a, b, reversed, left] = sides[i];
    std::size_t end = i;
    while (end < sides.size () && std::get<0> (sides[end]) == a && std::get<1> (sides[end]) == b)
      ++end;
    if (end - i == 2 && !reversed && std::get<2> (sides[i + 1]))
      edges.push_back ({a, b, left, std::get<3> (sides[i + 1])});
    i = end;
  }
  return edges;
}

void
splitLongestEdges (std::size_t count, Mesh& mesh)
{
  std::vector<MeshEdge> edges = edgesOf (mesh);
  std::stable_sort (edges.begin (), edges.end (),
                    [&] (const auto& x, const auto& y) { return lengthOf (mesh, x) > lengthOf (mesh, y); });
  std::vector<bool> changed (mesh.triangles.size ());
  for (const MeshEdge& edge : edges) {
    if (count == 0)
      return;
    if (changed[edge.left] || changed[edge.right])
      continue;
    changed[edge.left] = changed[edge.right] = true;
    const std::uint32_t c = opposite (mesh.triangles[edge.left], edge), d = opposite (mesh.triangles[edge.right], edge);
    const auto middle = static_cast<std::uint32_t> (mesh.vertices.size ());
    mesh.vertices.emplace_back ((mesh.vertices[edge.a] + mesh.vertices[edge.b]) / 2);
    mesh.triangles[edge.left] = {edge.a, middle, c};
    mesh.triangles[edge.right] = {edge.b, middle, d};
    mesh.triangles.push_back ({middle, edge.b, c});
    mesh.triangles.push_back ({middle, edge.a, d});
    --count;
  }
}

std::size_t
flipEdges (Mesh& mesh)
{
  const std::vector<MeshEdge> edges = edgesOf (mesh);
  std::set<VertexPair> present;
  for (const MeshEdge& edge : edges)
    present.insert ({edge.a, edge.b});
  std::vector<bool> changed (mesh.triangles.size ());
  std::size_t flips = 0;
  for (const MeshEdge& edge : edges) {
    const std::uint32_t c = opposite (mesh.triangles[edge.left], edge), d = opposite (mesh.triangles[edge.right], edge);
    constexpr double straight = M_PI + 1e-9;
    if (changed[edge.left] || changed[edge.right] || angleAt (mesh, c, edge) + angleAt (mesh, d, edge) <= straight ||
        !present.insert (std::minmax (c, d)).second)
      continue;
    changed[edge.left] = changed[edge.right] = true;
    mesh.triangles[edge.left] = {edge.a, d, c};
    mesh.triangles[edge.right] = {d, edge.b, c};
    ++flips;
  }
  return flips;
}
} // namespace tools
} // namespace pcl_normal_smoothing
