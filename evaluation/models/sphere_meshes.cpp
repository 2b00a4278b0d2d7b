// SPDX-License-Identifier: BSD-3-Clause
#include "models/sphere_meshes.h"

#include "meshes/mesh_edges.h"
#include "meshes/mesh_measures.h"
#include "models/jitter.h"
#include "models/subdivision.h"

#include <Eigen/Geometry>

#include <cmath>

namespace pcl_normal_smoothing::evaluation
{
namespace
{
/** A bump of the given height around a direction; the larger the sharpness, the narrower. */
struct Bump
{
  Eigen::Vector3d direction;
  double height, sharpness;

  double
  at (const Eigen::Vector3d& u) const
  {
    return height * std::exp (sharpness * (u.dot (direction) - 1));
  }
};

const std::vector<Bump>&
bumps ()
{
  static const std::vector<Bump> all {{Eigen::Vector3d (0.9, 0.2, 0.4).normalized (), 0.5, 8},
                                      {Eigen::Vector3d (-0.5, 0.8, 0.3).normalized (), 0.45, 12},
                                      {Eigen::Vector3d (-0.4, -0.7, 0.6).normalized (), 0.35, 20},
                                      {Eigen::Vector3d (0.2, 0.5, 0.9).normalized (), 0.25, 30},
                                      {Eigen::Vector3d (0.3, -0.6, -0.7).normalized (), 0.4, 6},
                                      {Eigen::Vector3d (0.1, 0.9, -0.5).normalized (), -0.25, 10},
                                      {Eigen::Vector3d (-0.9, 0.1, -0.1).normalized (), -0.2, 15}};
  return all;
}

double
radiusAt (const Eigen::Vector3d& u)
{
  double radius = 1;
  for (const Bump& bump : bumps ())
    radius += bump.at (u);
  return radius;
}

Eigen::Vector3d
ballGradient (const Eigen::Vector3d& p)
{
  const Eigen::Vector3d u = p.normalized ();
  Eigen::Vector3d gradient = u;
  for (const Bump& bump : bumps ())
    gradient -= bump.sharpness * bump.at (u) / p.norm () * (bump.direction - u.dot (bump.direction) * u);
  return gradient;
}

/** A conformal map of the sphere: scales distances by \a scale at the top and by 1 / \a scale at the bottom. */
Eigen::Vector3d
drawnUp (const Eigen::Vector3d& u, double scale)
{
  const double share = (1 - u.z ()) / (1 + u.z ()) * scale * scale; // tan^2 of half the angle from the top
  const double z = (1 - share) / (1 + share), flat = u.head<2> ().norm ();
  const double reach = flat > 0 ? std::sqrt (std::max (1 - z * z, 0.0)) / flat : 0;
  return {reach * u.x (), reach * u.y (), z};
}
} // namespace

tools::Mesh
makeSphere (int times)
{
  tools::Mesh mesh;
  const double golden = (1 + std::sqrt (5.0)) / 2;
  for (const double a : {-1.0, 1.0})
    for (const double b : {-golden, golden}) {
      mesh.vertices.emplace_back (0, a, b);
      mesh.vertices.emplace_back (a, b, 0);
      mesh.vertices.emplace_back (b, 0, a);
    }
  // Any three corners that are pairwise at a distance of 2 form a face, oriented outwards.
  const auto joined = [&] (std::uint32_t i, std::uint32_t j) {
    return (mesh.vertices[i] - mesh.vertices[j]).norm () < 2.1;
  };
  for (std::uint32_t i = 0; i < 12; ++i)
    for (std::uint32_t j = i + 1; j < 12; ++j)
      for (std::uint32_t k = j + 1; k < 12; ++k)
        if (joined (i, j) && joined (j, k) && joined (k, i)) {
          const bool outwards = mesh.vertices[i].dot (mesh.vertices[j].cross (mesh.vertices[k])) > 0;
          mesh.triangles.push_back ({i, outwards ? j : k, outwards ? k : j});
        }
  for (int step = 0; step < times; ++step) {
    subdivide (mesh);
    for (Eigen::Vector3d& vertex : mesh.vertices)
      vertex.normalize ();
  }
  return mesh;
}

const ImplicitSurface&
bumpyBall ()
{
  static const ImplicitSurface ball {[] (const Eigen::Vector3d& p) { return p.norm () - radiusAt (p.normalized ()); },
                                     ballGradient};
  return ball;
}

tools::Mesh
makeUnevenBall (int times)
{
  tools::Mesh mesh = makeSphere (times);
  const double spacing = tools::meanEdgeLength (mesh);
  Jitter jitter;
  for (Eigen::Vector3d& vertex : mesh.vertices) {
    const double x = jitter (), y = jitter (), z = jitter ();
    const Eigen::Vector3d shifted = vertex + 0.25 * spacing * Eigen::Vector3d (x, y, z);
    const Eigen::Vector3d u = drawnUp (shifted.normalized (), 0.5);
    vertex = radiusAt (u) * u;
  }
  while (tools::flipEdges (mesh) > 0) {}
  return mesh;
}

} // namespace pcl_normal_smoothing::evaluation
