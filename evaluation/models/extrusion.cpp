// SPDX-License-Identifier: BSD-3-Clause
#include "models/extrusion.h"

#include "models/jitter.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>

namespace pcl_normal_smoothing::evaluation
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;
using Outline = std::vector<Eigen::Vector2d>;

/** Points along a loop, about \a spacing apart, its corners included. */
Outline
sampled (const Loop& loop, double spacing)
{
  Outline points;
  for (const Piece& piece : loop) {
    const int parts = std::max (1, static_cast<int> (std::lround (piece.length () / spacing)));
    for (int i = 0; i < parts; ++i)
      points.push_back (piece.at (static_cast<double> (i) / parts));
  }
  return points;
}

/** The profile bounded by the polygons through the points of the outlines. */
Profile
chordsOf (const std::vector<Outline>& outlines)
{
  Profile chords;
  for (const Outline& outline : outlines)
    chords.loops.push_back (polygon (outline));
  return chords;
}

/** The points of a triangular grid inside the profile, off its outline, each jittered so that no two distances are
  * equal. */
Outline
innerPoints (const Profile& profile, const Outline& outer, double spacing)
{
  Eigen::Vector2d low = outer[0], high = outer[0];
  for (const Eigen::Vector2d& p : outer) {
    low = low.cwiseMin (p);
    high = high.cwiseMax (p);
  }
  Jitter jitter;
  Outline points;
  const double step = spacing * std::sqrt (3.0) / 2;
  bool odd = false;
  for (double y = low.y () + step; y < high.y (); y += step, odd = !odd)
    for (double x = low.x () + (odd ? spacing / 2 : spacing); x < high.x (); x += spacing) {
      const Eigen::Vector2d p (x + 0.15 * spacing * jitter (), y + 0.15 * spacing * jitter ());
      if (profile.contains (p) && profile.distance (p) > 0.6 * spacing)
        points.push_back (p);
    }
  return points;
}

/** Triangles over all points, which are numbered in order: first those of the outlines, then the inner ones. */
std::vector<tools::Mesh::Triangle>
triangulated (const std::vector<Outline>& outlines, const Outline& inner)
{
  Triangulation triangulation;
  std::uint32_t count = 0;
  const auto insert = [&] (const Eigen::Vector2d& p) {
    const auto vertex = triangulation.insert ({p.x (), p.y ()});
    vertex->info () = count++;
    return vertex;
  };
  for (const Outline& outline : outlines) {
    std::vector<Triangulation::Vertex_handle> vertices;
    std::transform (outline.begin (), outline.end (), std::back_inserter (vertices), insert);
    for (std::size_t i = 0; i < vertices.size (); ++i)
      triangulation.insert_constraint (vertices[i], vertices[(i + 1) % vertices.size ()]);
  }
  std::for_each (inner.begin (), inner.end (), insert);
  const Profile chords = chordsOf (outlines);
  std::vector<tools::Mesh::Triangle> triangles;
  for (const auto face : triangulation.finite_face_handles ()) {
    const auto middle = CGAL::centroid (triangulation.triangle (face));
    if (chords.contains ({middle.x (), middle.y ()}))
      triangles.push_back ({face->vertex (0)->info (), face->vertex (1)->info (), face->vertex (2)->info ()});
  }
  return triangles;
}

/** Collects the vertices and triangles of the body. */
class Body
{
public:
  Body (const std::vector<Outline>& outlines, double height, int levels)
  : outlines_ (outlines), height_ (height), levels_ (levels)
  {}

  tools::Mesh
  build (const Outline& inner)
  {
    for (int level = 0; level <= levels_; ++level)
      for (const Outline& outline : outlines_)
        for (const Eigen::Vector2d& p : outline)
          mesh_.vertices.emplace_back (p.x (), p.y (), height_ * level / levels_);
    on_level_ = mesh_.vertices.size () / (static_cast<std::size_t> (levels_) + 1);
    for (const double z : {0.0, height_})
      for (const Eigen::Vector2d& p : inner)
        mesh_.vertices.emplace_back (p.x (), p.y (), z);
    addWalls ();
    for (const auto& [a, b, c] : triangulated (outlines_, inner)) {
      mesh_.triangles.push_back ({capVertex (a, 0, 0), capVertex (c, 0, 0), capVertex (b, 0, 0)});
      const std::size_t top = static_cast<std::size_t> (levels_) * on_level_;
      mesh_.triangles.push_back (
          {capVertex (a, top, inner.size ()), capVertex (b, top, inner.size ()), capVertex (c, top, inner.size ())});
    }
    return mesh_;
  }

private:
  /** The index in the mesh of vertex \a v of a cap. */
  std::uint32_t
  capVertex (std::uint32_t v, std::size_t outline_begin, std::size_t inner_begin) const
  {
    const std::size_t walls = (static_cast<std::size_t> (levels_) + 1) * on_level_;
    return static_cast<std::uint32_t> (v < on_level_ ? outline_begin + v : walls + inner_begin + v - on_level_);
  }

  void
  addWalls ()
  {
    for (std::uint32_t level = 0; level < static_cast<std::uint32_t> (levels_); ++level) {
      auto first = static_cast<std::uint32_t> (level * on_level_);
      for (const Outline& outline : outlines_) {
        const auto size = static_cast<std::uint32_t> (outline.size ());
        const auto up = static_cast<std::uint32_t> (on_level_);
        for (std::uint32_t i = 0; i < size; ++i) {
          const std::uint32_t a = first + i, b = first + (i + 1) % size;
          if ((i + level) % 2 == 0) { // alternating diagonals
            mesh_.triangles.push_back ({a, b, b + up});
            mesh_.triangles.push_back ({a, b + up, a + up});
          }
          else {
            mesh_.triangles.push_back ({a, b, a + up});
            mesh_.triangles.push_back ({b, b + up, a + up});
          }
        }
        first += size;
      }
    }
  }

  const std::vector<Outline>& outlines_;
  double height_;
  int levels_;
  std::size_t on_level_ = 0;
  tools::Mesh mesh_;
};
} // namespace

tools::Mesh
extrude (const Profile& profile, double height, double spacing)
{
  std::vector<Outline> outlines;
  for (const Loop& loop : profile.loops)
    outlines.push_back (sampled (loop, spacing));
  const int levels = std::max (1, static_cast<int> (std::lround (height / spacing)));
  return Body (outlines, height, levels).build (innerPoints (profile, outlines[0], spacing));
}

double
distanceToExtrusion (const Profile& profile, double height, const Eigen::Vector3d& point)
{
  const Eigen::Vector2d flat = point.head<2> ();
  const double to_outline = profile.distance (flat);
  const double above = std::max ({point.z () - height, -point.z (), 0.0});
  const double to_wall = std::hypot (to_outline, above);
  const double to_planes = std::min (std::abs (point.z ()), std::abs (point.z () - height));
  return profile.contains (flat) ? std::min (to_wall, to_planes) : to_wall;
}

} // namespace pcl_normal_smoothing::evaluation
