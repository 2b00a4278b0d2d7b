// SPDX-License-Identifier: BSD-3-Clause
#include "double_torus.h"

#include "mesh_edges.h"

#include <pcl_normal_smoothing/core/error.h>

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
constexpr double flatness = 0.8, thickness = 0.12;
constexpr double major_radius = 0.55, minor_radius = 0.25, centre_x = 0.62, width_of_joint = 0.15;

/** A function that is 0 on a figure of eight. */
double
eightAt (const Eigen::Vector3d& p)
{
  return p.x () * p.x () * (1 - p.x () * p.x ()) - p.y () * p.y ();
}

/** Signed distance to the torus on one side. \param[out] gradient of that distance */
double
torusAt (Eigen::Vector3d p, double side, Eigen::Vector3d& gradient)
{
  p.x () -= side * centre_x;
  const double flat = std::max (p.head<2> ().norm (), 1e-12), out = flat - major_radius;
  const double to_circle = std::max (std::hypot (out, p.z ()), 1e-12);
  gradient = Eigen::Vector3d (out * p.x () / flat, out * p.y () / flat, p.z ()) / to_circle;
  return to_circle - minor_radius;
}

/** The smooth minimum of the distances to both tori, with a continuous curvature. */
double
joinedAt (const Eigen::Vector3d& p, Eigen::Vector3d& gradient)
{
  Eigen::Vector3d of_left, of_right;
  const double left = torusAt (p, -1, of_left), right = torusAt (p, 1, of_right);
  const double share = std::max (width_of_joint - std::abs (left - right), 0.0) / width_of_joint;
  const double of_farther = share * share / 2;
  gradient = left < right ? (1 - of_farther) * of_left + of_farther * of_right
                          : (1 - of_farther) * of_right + of_farther * of_left;
  return std::min (left, right) - share * share * share * width_of_joint / 6;
}
} // namespace

DoubleTorus
figureOfEight ()
{
  const auto value = [] (const Eigen::Vector3d& p) {
    return std::pow (eightAt (p), 2) + std::pow (flatness * p.z (), 2) - thickness * thickness;
  };
  const auto gradient = [] (const Eigen::Vector3d& p) {
    const double eight = eightAt (p);
    return Eigen::Vector3d (2 * eight * (2 * p.x () - 4 * p.x () * p.x () * p.x ()), -4 * eight * p.y (),
                            2 * flatness * flatness * p.z ());
  };
  return {value, gradient, {1.2, 0.7, 0.25}};
}

DoubleTorus
joinedTori ()
{
  const auto value = [] (const Eigen::Vector3d& p) {
    Eigen::Vector3d gradient;
    return joinedAt (p, gradient);
  };
  const auto gradient = [] (const Eigen::Vector3d& p) {
    Eigen::Vector3d of_joined;
    joinedAt (p, of_joined);
    return of_joined;
  };
  return {value, gradient, {1.5, 0.9, 0.3}};
}

namespace
{
/** Moves a point to the surface by Newton's method along the gradient. */
Eigen::Vector3d
projected (const DoubleTorus& torus, Eigen::Vector3d p)
{
  for (int step = 0; step < 10; ++step) {
    const Eigen::Vector3d gradient = torus.gradient (p);
    p -= torus.value (p) / std::max (gradient.squaredNorm (), 1e-12) * gradient;
  }
  return p;
}

/** Extracts the surface from a grid of cells with side \a spacing. */
Mesh
sampled (const DoubleTorus& torus, double spacing)
{
  vtkNew<vtkImageData> grid;
  std::array<int, 3> size;
  for (std::size_t d = 0; d < 3; ++d)
    size[d] = static_cast<int> (2 * torus.box[static_cast<int> (d)] / spacing) + 2;
  grid->SetDimensions (size.data ());
  grid->SetSpacing (spacing, spacing, spacing);
  grid->SetOrigin (Eigen::Vector3d (-torus.box).data ());
  grid->AllocateScalars (VTK_DOUBLE, 1);
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints (); ++i)
    grid->GetPointData ()->GetScalars ()->SetTuple1 (i, torus.value (Eigen::Vector3d (grid->GetPoint (i))));
  vtkNew<vtkFlyingEdges3D> surface;
  surface->SetInputData (grid);
  surface->SetValue (0, 0.0);
  surface->ComputeNormalsOff ();
  surface->Update ();
  vtkPolyData* output = surface->GetOutput ();
  Mesh mesh;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints (); ++i)
    mesh.vertices.push_back (projected (torus, Eigen::Vector3d (output->GetPoint (i))));
  for (vtkIdType t = 0; t < output->GetNumberOfCells (); ++t) {
    vtkIdType count;
    const vtkIdType* corners;
    output->GetPolys ()->GetCellAtId (t, count, corners);
    mesh.triangles.push_back ({static_cast<std::uint32_t> (corners[0]), static_cast<std::uint32_t> (corners[2]),
                               static_cast<std::uint32_t> (corners[1])}); // VTK's triangles face down the gradient
  }
  return mesh;
}

/** Moves every vertex halfway to the mean of its neighbours, and back to the surface. */
void
relax (const DoubleTorus& torus, Mesh& mesh)
{
  std::vector<Eigen::Vector3d> sums (mesh.vertices.size (), Eigen::Vector3d::Zero ());
  std::vector<double> counts (mesh.vertices.size ());
  for (const MeshEdge& edge : edgesOf (mesh))
    for (const auto& [a, b] : {std::pair (edge.a, edge.b), std::pair (edge.b, edge.a)}) {
      sums[a] += mesh.vertices[b];
      counts[a] += 1;
    }
  for (std::size_t i = 0; i < mesh.vertices.size (); ++i)
    mesh.vertices[i] = projected (torus, mesh.vertices[i] + 0.5 * (sums[i] / counts[i] - mesh.vertices[i]));
}
} // namespace

Mesh
makeDoubleTorus (const DoubleTorus& torus, std::size_t vertices)
{
  // Slightly too few vertices from the grid, the rest from splitting the longest edges.
  double spacing = 0.2;
  Mesh mesh = sampled (torus, spacing);
  for (Mesh finer = mesh; finer.vertices.size () <= vertices; finer = sampled (torus, spacing)) {
    mesh = std::move (finer);
    spacing *= 0.99;
  }
  constexpr int rounds = 60;
  for (int round = 0; round < rounds; ++round) {
    while (mesh.vertices.size () < vertices)
      splitLongestEdges (vertices - mesh.vertices.size (), mesh);
    flipEdges (mesh);
    relax (torus, mesh);
  }
  while (flipEdges (mesh) > 0) {}
  const auto v = static_cast<std::ptrdiff_t> (mesh.vertices.size ()),
             f = static_cast<std::ptrdiff_t> (mesh.triangles.size ());
  if (mesh.vertices.size () != vertices || v - static_cast<std::ptrdiff_t> (edgesOf (mesh).size ()) + f != -2)
    throw core::Error ("no double torus of " + std::to_string (vertices) + " vertices came about: try another number");
  return mesh;
}
} // namespace tools
} // namespace pcl_normal_smoothing
