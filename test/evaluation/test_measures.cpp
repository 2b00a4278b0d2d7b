// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation_meshes.h"
#include "measures/measures.h"
#include "measures/sharp_edges.h"
#include "meshes/mesh_measures.h"
#include "meshes/smoothing_error.h"
#include "meshes/surface_noise.h"
#include "models/extrusion.h"
#include "models/made_models.h"

#include <pcl_normal_smoothing/core/error.h>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>

using namespace pcl_normal_smoothing;
using namespace pcl_normal_smoothing::evaluation;

namespace
{
/** The vertices of a flat square, lifted by \a height mean edge lengths. */
tools::Points
lifted (const Model& model, double height)
{
  tools::Points points = model.mesh.vertices;
  for (Eigen::Vector3d& point : points)
    point.z () += height * tools::meanEdgeLength (model.mesh);
  return points;
}

Model
squareModel ()
{
  return {"square", "", squareMesh (20), [] (const Eigen::Vector3d& p) { return std::abs (p.z ()); }};
}

Model
cubeModel ()
{
  return {"cube", "", extrude ({{polygon ({{0, 0}, {1, 0}, {1, 1}, {0, 1}})}}, 1, 0.1), {}};
}
} // namespace

TEST (Measures, OfALiftedSquare)
{
  const Model square = squareModel ();
  Evaluator evaluator (square);
  evaluator.setNoisy (lifted (square, -0.5));
  tools::Points normals (square.mesh.vertices.size (), Eigen::Vector3d (0, -1, 1).normalized ());
  const Measures measures = evaluator.measure (lifted (square, 0.2), normals, MeasureSet::ALL);
  EXPECT_NEAR (measures.p2s_mean, 0.2, 1e-9);
  EXPECT_NEAR (measures.p2s_rms, 0.2, 1e-9);
  EXPECT_NEAR (measures.p2s_max, 0.2, 1e-9);
  EXPECT_NEAR (measures.p2s_ratio, 0.4, 1e-9);
  EXPECT_NEAR (measures.p2p_mean, 0.2, 1e-9);
  EXPECT_NEAR (measures.p2p_ratio, 0.4, 1e-9);
  EXPECT_NEAR (measures.exact_mean, 0.2, 1e-9);
  EXPECT_NEAR (measures.exact_ratio, 0.4, 1e-9);
  EXPECT_NEAR (measures.normal_angle, 0, 1e-4);
  EXPECT_NEAR (measures.own_normal_angle, 45, 1e-9);
  EXPECT_NEAR (measures.spacing_p01, 1, 1e-6);
  EXPECT_NEAR (measures.area_error, 0, 1e-12);
  EXPECT_NEAR (measures.variation_error_15, 0, 1e-9);
  EXPECT_TRUE (std::isnan (measures.edge_error)); // no sharp edge
  EXPECT_TRUE (std::isnan (measures.edge_fraction));
}

TEST (Measures, MeanRmsAndMaximumDiffer)
{
  const Model square = squareModel ();
  Evaluator evaluator (square);
  tools::Points points = square.mesh.vertices; // a quarter of them 1 above the square, the others on it
  for (std::size_t i = 0; i < points.size (); i += 4)
    points[i].z () += evaluator.meanEdge ();
  evaluator.setNoisy (points);
  const Measures measures = evaluator.measure (points, {}, MeasureSet::ALL);
  EXPECT_NEAR (measures.p2s_mean, 0.25, 1e-9);
  EXPECT_NEAR (measures.p2s_rms, 0.5, 1e-9);
  EXPECT_NEAR (measures.p2s_max, 1, 1e-9);
  EXPECT_NEAR (measures.p2s_ratio, 1, 1e-12);
  EXPECT_TRUE (std::isnan (measures.own_normal_angle));
}

TEST (Measures, PointsThatSlideOnTheSurface)
{
  const Model square = squareModel ();
  Evaluator evaluator (square);
  evaluator.setNoisy (lifted (square, 1));
  tools::Points points = square.mesh.vertices;
  for (Eigen::Vector3d& point : points) // towards the middle
    point = Eigen::Vector3d (0.5, 0.5, 0) + 0.5 * (point - Eigen::Vector3d (0.5, 0.5, 0));
  const Measures measures = evaluator.measure (points, {}, MeasureSet::ALL);
  EXPECT_NEAR (measures.p2s_mean, 0, 1e-9);
  EXPECT_GT (measures.p2p_mean, 1);
  EXPECT_NEAR (measures.spacing_p01, 0.5, 1e-6);
  EXPECT_NEAR (measures.area_error, 0.75, 1e-9);
}

TEST (Measures, PointsThatClump)
{
  const Model square = squareModel ();
  Evaluator evaluator (square);
  evaluator.setNoisy (square.mesh.vertices);
  tools::Points points = square.mesh.vertices;
  for (std::size_t i = 21; i < 361; i += 60) // six points move close to neighbours: 3 % are then close to another
    points[i] = points[i + 1] + 0.1 * (points[i] - points[i + 1]);
  EXPECT_NEAR (evaluator.measure (points, {}, MeasureSet::ALL).spacing_p01, 0.1, 1e-5);
}

TEST (Measures, EdgesOfACube)
{
  const Model cube = cubeModel ();
  Evaluator evaluator (cube);
  const auto near = verticesNearSharpEdges (cube.mesh, 30, 0.5 * evaluator.meanEdge ());
  EXPECT_EQ (near.size (), 12u * 9 + 8); // nine inner vertices per edge, and the corners
  std::size_t within = 0;                // near an edge: two coordinates are close to a face
  for (const Eigen::Vector3d& p : cube.mesh.vertices)
    within += (p.array () <= 0.11 || p.array () >= 0.89).count () >= 2 ? 1 : 0;
  EXPECT_EQ (verticesNearSharpEdges (cube.mesh, 30, 0.11).size (), within);
  EXPECT_GT (within, near.size ());
  EXPECT_TRUE (verticesNearSharpEdges (cube.mesh, 100, 1).empty ());

  // Lifted by 0.3 away from the edges; on the edges, every other point by 0.2 and the rest not at all.
  tools::Points points = cube.mesh.vertices;
  const auto normals = tools::vertexNormals (cube.mesh);
  std::vector<double> lifts (points.size (), 0.3);
  for (std::size_t i = 0; i < near.size (); ++i)
    lifts[near[i]] = i % 2 == 0 ? 0.2 : 0;
  for (std::size_t i = 0; i < points.size (); ++i)
    points[i] += lifts[i] * evaluator.meanEdge () * normals[i];
  evaluator.setNoisy (points);
  const Measures measures = evaluator.measure (points, {}, MeasureSet::ALL);
  EXPECT_NEAR (measures.edge_error, 0.1, 1e-9);
  EXPECT_NEAR (measures.edge_fraction, 0.5, 1e-9);
}

TEST (Measures, AgreeWithTheToolsOwn)
{
  const Model model = makeModel ("double_torus");
  Evaluator evaluator (model);
  const double edge = evaluator.meanEdge ();
  const auto noisy = tools::noisyVertices (model.mesh, tools::NoiseType::GR, 0.2 * edge, 3);
  evaluator.setNoisy (noisy);
  const Measures measures = evaluator.measure (noisy, {}, MeasureSet::ALL);
  const tools::SurfaceDistance distance = tools::distanceToMesh (noisy, model.mesh); // by VTK
  EXPECT_NEAR (measures.p2s_mean, distance.mean / edge, 1e-9);
  EXPECT_NEAR (measures.p2s_rms, distance.rms / edge, 1e-9);
  EXPECT_NEAR (measures.p2s_max, distance.max / edge, 1e-9);
  EXPECT_NEAR (measures.variation_error_7, tools::variationError (noisy, model.mesh.vertices, 7), 1e-12);
  EXPECT_NEAR (measures.variation_error_15, tools::variationError (noisy, model.mesh.vertices, 15), 1e-12);
  EXPECT_NEAR (measures.variation_error_21, tools::variationError (noisy, model.mesh.vertices, 21), 1e-12);
  EXPECT_DOUBLE_EQ (measures.area_error, tools::areaError (noisy, model.mesh));
  // The mean of the length is that of |N(0, 1)|; that of its component along the normal is half of it.
  EXPECT_NEAR (measures.exact_mean, 0.2 * std::sqrt (2 / 3.14159265) / 2, 0.003);
  EXPECT_NEAR (measures.p2p_mean, 0.2 * std::sqrt (2 / 3.14159265), 0.006);
  const Measures paper = evaluator.measure (noisy, {}, MeasureSet::PAPER);
  EXPECT_DOUBLE_EQ (paper.variation_error_15, measures.variation_error_15);
  EXPECT_DOUBLE_EQ (paper.area_error, measures.area_error);
  EXPECT_TRUE (std::isnan (paper.p2s_mean));
}

TEST (Measures, RefuseWhatIsNoResult)
{
  const Model square = squareModel ();
  Evaluator evaluator (square);
  tools::Points points = square.mesh.vertices;
  points[7].x () = std::nan ("");
  EXPECT_THROW (evaluator.measure (points, {}, MeasureSet::ALL), core::Error);
  points.pop_back ();
  EXPECT_THROW (evaluator.measure (points, {}, MeasureSet::ALL), core::Error);
}
