// SPDX-License-Identifier: BSD-3-Clause
#include "models/mesh_model.h"

#include "models/subdivision.h"

#include <pcl_normal_smoothing/core/error.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <filesystem>
#include <limits>

namespace pcl_normal_smoothing::evaluation
{
namespace
{
constexpr std::size_t least_vertices = 22; // the largest neighbourhood is 21

bool
hasArea (const tools::Mesh& mesh, const tools::Mesh::Triangle& t)
{
  const Eigen::Vector3d u = mesh.vertices[t[1]] - mesh.vertices[t[0]], v = mesh.vertices[t[2]] - mesh.vertices[t[0]];
  return u.cross (v).norm () > 1e-12 * std::max (u.squaredNorm (), v.squaredNorm ());
}

/** \return the number removed */
std::size_t
removeFlatTriangles (tools::Mesh& mesh)
{
  const std::size_t before = mesh.triangles.size ();
  mesh.triangles.erase (std::remove_if (mesh.triangles.begin (), mesh.triangles.end (),
                                        [&] (const auto& t) { return !hasArea (mesh, t); }),
                        mesh.triangles.end ());
  return before - mesh.triangles.size ();
}

/** \return the number removed */
std::size_t
removeUnusedVertices (tools::Mesh& mesh)
{
  constexpr auto unused = std::numeric_limits<std::uint32_t>::max ();
  std::vector<std::uint32_t> place (mesh.vertices.size (), unused);
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t corner : t)
      place[corner] = 0;
  std::vector<Eigen::Vector3d> kept;
  for (std::size_t i = 0; i < place.size (); ++i)
    if (place[i] != unused) {
      place[i] = static_cast<std::uint32_t> (kept.size ());
      kept.push_back (mesh.vertices[i]);
    }
  for (auto& t : mesh.triangles)
    for (std::uint32_t& corner : t)
      corner = place[corner];
  mesh.vertices.swap (kept);
  return kept.size () - mesh.vertices.size ();
}

/** Moves a mesh to the origin if its distance from it exceeds twice its diagonal. \return whether it was moved */
bool
moveToZero (tools::Mesh& mesh)
{
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& vertex : mesh.vertices)
    box.extend (vertex);
  const Eigen::Vector3d center = box.center ();
  if (center.norm () < 2 * box.diagonal ().norm ())
    return false;
  for (Eigen::Vector3d& vertex : mesh.vertices)
    vertex -= center;
  return true;
}

std::string
counted (std::size_t count, const std::string& what)
{
  return ", " + std::to_string (count) + " " + what;
}
} // namespace

std::string
modelName (const std::string& path)
{
  return std::filesystem::path (path).stem ().string ();
}

Model
loadModel (const std::string& path, int subdivisions)
{
  Model model {modelName (path), path, tools::loadMesh (path), {}};
  if (const std::size_t flat = removeFlatTriangles (model.mesh))
    model.source += counted (flat, "triangles without an area left out");
  if (const std::size_t unused = removeUnusedVertices (model.mesh))
    model.source += counted (unused, "vertices without a triangle left out");
  if (moveToZero (model.mesh))
    model.source += ", moved to zero";
  for (int step = 0; step < subdivisions; ++step)
    subdivide (model.mesh);
  if (subdivisions > 0)
    model.source += ", split at the middles of the edges" + counted (static_cast<std::size_t> (subdivisions), "times");
  if (model.mesh.vertices.size () < least_vertices)
    throw core::Error (path + ": " + std::to_string (model.mesh.vertices.size ()) +
                       " vertices with a triangle are fewer than " + std::to_string (least_vertices) +
                       ", too few for neighbourhoods of 21: give a finer mesh, or subdivide it");
  return model;
}

} // namespace pcl_normal_smoothing::evaluation
