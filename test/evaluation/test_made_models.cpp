// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation_meshes.h"
#include "meshes/mesh_edges.h"
#include "meshes/mesh_measures.h"
#include "models/extrusion.h"
#include "models/implicit_surface.h"
#include "models/made_models.h"
#include "models/sheets.h"

#include <pcl_normal_smoothing/core/error.h>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace pcl_normal_smoothing;
using namespace pcl_normal_smoothing::evaluation;

namespace
{
constexpr double pi = 3.14159265358979324;

const Model&
madeModel (const std::string& name)
{
  static std::map<std::string, Model> models;
  const auto found = models.find (name);
  return found == models.end () ? models.emplace (name, makeModel (name)).first->second : found->second;
}

double
smallestAngle (const tools::Mesh& mesh)
{
  double smallest = 180;
  for (const auto& t : mesh.triangles)
    for (std::size_t c = 0; c < 3; ++c) {
      const Eigen::Vector3d u = mesh.vertices[t[(c + 1) % 3]] - mesh.vertices[t[c]],
                            v = mesh.vertices[t[(c + 2) % 3]] - mesh.vertices[t[c]];
      smallest = std::min (smallest, std::atan2 (u.cross (v).norm (), u.dot (v)) * 180 / pi);
    }
  return smallest;
}

Profile
roundedSquareWithHole ()
{
  Loop outline = polygon ({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  roundCorner (1, 0.5, outline);
  return {{outline, circularHole ({0.7, 0.8}, 0.3)}};
}
} // namespace

TEST (MadeModels, EveryOneIsASoundMeshOnItsSurface)
{
  for (const std::string& name : madeModelNames ()) {
    const Model& model = madeModel (name);
    EXPECT_EQ (model.name, name);
    EXPECT_FALSE (model.source.empty ());
    EXPECT_GT (model.mesh.vertices.size (), 4000u) << name;
    EXPECT_GT (smallestAngle (model.mesh), 8) << name;
    ASSERT_TRUE (model.surface_distance) << name;
    for (const Eigen::Vector3d& vertex : model.mesh.vertices)
      ASSERT_LT (model.surface_distance (vertex), 1e-9) << name << " " << vertex.transpose ();
    if (name.rfind ("two_sheets", 0) == 0)
      continue;
    EXPECT_EQ (2 * tools::edgesOf (model.mesh).size (), 3 * model.mesh.triangles.size ()) << name << " is not closed";
    EXPECT_GT (volumeOf (model.mesh), 0) << name << " is inside out";
  }
  EXPECT_EQ (madeModel ("double_torus").mesh.vertices.size (), 4350u);
  EXPECT_THROW (makeModel ("teapot"), core::Error);
}

TEST (MadeModels, AreAsLargeAsTheirShapes)
{
  EXPECT_NEAR (tools::area (madeModel ("cube").mesh), 6, 1e-9);
  EXPECT_NEAR (volumeOf (madeModel ("cube").mesh), 1, 1e-9);
  EXPECT_NEAR (volumeOf (madeModel ("plate").mesh), 1 * 0.75 * 0.04, 1e-9);
  EXPECT_NEAR (tools::area (madeModel ("sphere").mesh), 4 * pi, 0.01);
  EXPECT_NEAR (tools::area (madeModel ("two_sheets").mesh), 2, 1e-9);
  EXPECT_NEAR (tools::area (madeModel ("two_sheets_apart").mesh), 2, 1e-9);
  // The L shape, less the material outside the rounded corner, plus the fillet, less the bore.
  const double corner = 1 - pi / 4;
  const double section = 1.4 * 0.45 + 0.5 * 0.65 - 0.04 * corner + 0.0225 * corner - pi * 0.11 * 0.11;
  EXPECT_NEAR (volumeOf (madeModel ("csg_part").mesh), 0.4 * section, 0.4 * 1e-3);
}

TEST (MadeModels, OrganicIsSampledUnevenly)
{
  const tools::Mesh& mesh = madeModel ("organic").mesh;
  double top = 0, bottom = 0, top_count = 0, bottom_count = 0;
  for (const tools::MeshEdge& edge : tools::edgesOf (mesh)) {
    const Eigen::Vector3d &a = mesh.vertices[edge.a], &b = mesh.vertices[edge.b];
    if (a.normalized ().z () > 0.9) {
      top += (a - b).norm ();
      ++top_count;
    }
    if (a.normalized ().z () < -0.9) {
      bottom += (a - b).norm ();
      ++bottom_count;
    }
  }
  EXPECT_GT (bottom / bottom_count, 2 * top / top_count);
}

TEST (MadeModels, SheetsAreAsCloseAsTheirPoints)
{
  const Model& model = madeModel ("two_sheets");
  const double gap = 1.0 / 49;
  EXPECT_NEAR (model.surface_distance ({0.5, 0.5, 0.3 * gap}), 0.3 * gap, 1e-12);
  EXPECT_NEAR (model.surface_distance ({0.5, 0.5, 0.8 * gap}), 0.2 * gap, 1e-12);
  EXPECT_NEAR (model.surface_distance ({1.3, -0.4, 0}), 0.5, 1e-12);
  EXPECT_NEAR (gap / tools::meanEdgeLength (model.mesh), 1, 0.2);
  EXPECT_NEAR (madeModel ("two_sheets_apart").surface_distance ({0.5, 0.5, 0.3 * gap}), 0.3 * gap, 1e-12);
  EXPECT_NEAR (madeModel ("two_sheets_apart").surface_distance ({0.5, 0.5, 1.8 * gap}), 0.2 * gap, 1e-12);
  const auto normals = tools::vertexNormals (model.mesh);
  EXPECT_LT (normals.front ().z (), -0.999); // the sheets' normals point away from each other
  EXPECT_GT (normals.back ().z (), 0.999);
}

TEST (Profiles, DistanceAndInsideAgainstADenseOutline)
{
  const Profile profile = roundedSquareWithHole ();
  std::vector<Eigen::Vector2d> outline;
  for (const Loop& loop : profile.loops)
    for (const Piece& piece : loop)
      for (int i = 0; i < 2000; ++i)
        outline.push_back (piece.at (i / 2000.0));
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector2d p (std::fmod (i * 0.754877666, 1) * 3 - 0.5, std::fmod (i * 0.569840291, 1) * 3 - 0.5);
    double nearest = 10;
    for (const Eigen::Vector2d& q : outline)
      nearest = std::min (nearest, (p - q).norm ());
    EXPECT_NEAR (profile.distance (p), nearest, 1e-3) << p.transpose ();
    const bool in_square = p.x () > 0 && p.x () < 2 && p.y () > 0 && p.y () < 2;
    const bool cut_off = p.x () > 1.5 && p.y () > 1.5 && (p - Eigen::Vector2d (1.5, 1.5)).norm () > 0.5;
    const bool in_hole = (p - Eigen::Vector2d (0.7, 0.8)).norm () < 0.3;
    EXPECT_EQ (profile.contains (p), in_square && !cut_off && !in_hole) << p.transpose ();
  }
}

TEST (Profiles, DistanceToAnExtrusion)
{
  const Profile square {{polygon ({{0, 0}, {1, 0}, {1, 1}, {0, 1}})}};
  EXPECT_NEAR (distanceToExtrusion (square, 2, {0.5, 0.5, 1.9}), 0.1, 1e-12);
  EXPECT_NEAR (distanceToExtrusion (square, 2, {0.2, 0.5, 1}), 0.2, 1e-12);
  EXPECT_NEAR (distanceToExtrusion (square, 2, {0.5, 0.5, 2.7}), 0.7, 1e-12);
  EXPECT_NEAR (distanceToExtrusion (square, 2, {1.3, 1.4, 0.7}), 0.5, 1e-12);
  EXPECT_NEAR (distanceToExtrusion (square, 2, {1.2, 1.3, -0.6}), 0.7, 1e-12); // offsets of 2, 3 and 6 tenths
}

TEST (ImplicitSurfaces, DistanceToASphereAndATorus)
{
  const ImplicitSurface sphere {[] (const Eigen::Vector3d& p) { return p.squaredNorm () - 4; },
                                [] (const Eigen::Vector3d& p) { return Eigen::Vector3d (2 * p); }};
  EXPECT_NEAR (distanceTo (sphere, {1, 2, 2}), 1, 1e-9);
  EXPECT_NEAR (distanceTo (sphere, {0, 0, 1.7}), 0.3, 1e-9);
  const ImplicitSurface torus {[] (const Eigen::Vector3d& p) {
                                 return std::pow (p.head<2> ().norm () - 3, 2) + p.z () * p.z () - 1;
                               },
                               [] (const Eigen::Vector3d& p) {
                                 const double flat = p.head<2> ().norm ();
                                 return Eigen::Vector3d (2 * (flat - 3) * p.x () / flat, 2 * (flat - 3) * p.y () / flat,
                                                         2 * p.z ());
                               }};
  EXPECT_NEAR (distanceTo (torus, {3.0, 0.1, 1.5}), std::hypot (std::hypot (3, 0.1) - 3, 1.5) - 1, 1e-9);
  EXPECT_NEAR (distanceTo (torus, {0, 2.3, 0.2}), 1 - std::hypot (0.7, 0.2), 1e-9);
}

TEST (ImplicitSurfaces, PointsLiftedAlongTheNormal)
{
  for (const char* name : {"double_torus", "double_torus_round", "organic"}) {
    const Model& model = madeModel (name);
    const auto normals = tools::vertexNormals (model.mesh);
    const double edge = tools::meanEdgeLength (model.mesh);
    for (std::size_t i = 0; i < model.mesh.vertices.size (); i += 97)
      for (const double lift : {-0.3, 0.3}) // tolerance: the mesh's normals only approximate the surface's
        EXPECT_NEAR (model.surface_distance (model.mesh.vertices[i] + lift * edge * normals[i]) / edge, 0.3, 0.04)
            << name << " " << i;
  }
}
