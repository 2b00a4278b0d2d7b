// SPDX-License-Identifier: BSD-3-Clause
#include "measures/hinted_mesh_distance.h"

#include "measures/cgal_point.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>

#include <cmath>

namespace pcl_normal_smoothing::evaluation
{
namespace
{
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
} // namespace

struct HintedMeshDistance::Tree
{
  Triangles triangles;
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree;
};

HintedMeshDistance::HintedMeshDistance (const tools::Mesh& mesh) : tree_ (std::make_unique<Tree> ())
{
  for (const auto& [a, b, c] : mesh.triangles)
    tree_->triangles.emplace_back (toCgal (mesh.vertices[a]), toCgal (mesh.vertices[b]), toCgal (mesh.vertices[c]));
  tree_->tree.insert (tree_->triangles.begin (), tree_->triangles.end ());
  tree_->tree.build (); // built now, as queries come from many threads
}

HintedMeshDistance::~HintedMeshDistance () = default;

double
HintedMeshDistance::operator() (const Eigen::Vector3d& point, const Eigen::Vector3d& on_mesh) const
{
  const Kernel::Point_3 query = toCgal (point);
  return std::sqrt (CGAL::squared_distance (query, tree_->tree.closest_point (query, toCgal (on_mesh))));
}

} // namespace pcl_normal_smoothing::evaluation
