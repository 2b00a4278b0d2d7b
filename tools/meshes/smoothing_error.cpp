// SPDX-License-Identifier: BSD-3-Clause
#include "smoothing_error.h"

#include "mesh_distance.h"
#include "mesh_measures.h"

#include <pcl_normal_smoothing/core/chain/surface_estimation.h>
#include <pcl_normal_smoothing/core/search/neighbor_graph.h>
#include <pcl_normal_smoothing/vector_layout.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
using Points = std::vector<Eigen::Vector3d>;

/** The surface variation of every point. */
std::vector<double>
variations (const Points& points, unsigned k)
{
  const VectorLayout layout (sizeof (Eigen::Vector3d), {0, 8, 16}, VectorLayout::Scalar::FLOAT64);
  const core::Positions cloud =
      readPositions ({layout, reinterpret_cast<const std::uint8_t*> (points.data ()), points.size ()});
  core::NeighborQuery query;
  query.k = k;
  const core::Execution execution;
  const auto graph = core::NeighborGraph::build (cloud, query, execution);
  const auto surfaces =
      core::estimateSurfaces (*graph, core::gather (cloud, graph->order ()), core::pcaSurface, execution);
  std::vector<double> result (points.size (), std::numeric_limits<double>::quiet_NaN ());
  for (std::size_t node = 0; node < surfaces.size (); ++node)
    result[graph->order ()[node]] = surfaces[node].variation;
  return result;
}

/** Mean of the numbers that are not NaN; NaN if there are none. */
double
meanOf (const std::vector<double>& numbers)
{
  double sum = 0;
  std::size_t count = 0;
  for (const double number : numbers)
    if (!std::isnan (number)) {
      sum += number;
      ++count;
    }
  return sum / static_cast<double> (count);
}
} // namespace

SurfaceDistance
distanceToMesh (const Points& points, const Mesh& mesh)
{
  const MeshDistance distance (mesh);
  SurfaceDistance result;
  double sum = 0, sum_of_squares = 0;
  for (const Eigen::Vector3d& point : points) {
    const double length = distance.of (point);
    sum += length;
    sum_of_squares += length * length;
    result.max = std::max (result.max, length);
  }
  const auto count = static_cast<double> (points.size ());
  result.mean = sum / count;
  result.rms = std::sqrt (sum_of_squares / count);
  return result;
}

double
areaError (const Points& points, const Mesh& mesh)
{
  const double clean = area (mesh);
  return std::abs (area ({points, mesh.triangles}) - clean) / clean;
}

double
variationError (const Points& points, const Points& clean, unsigned k)
{
  std::vector<double> difference = variations (points, k);
  const std::vector<double> expected = variations (clean, k);
  for (std::size_t i = 0; i < difference.size (); ++i)
    difference[i] = std::abs (difference[i] - expected[i]);
  return meanOf (difference);
}

double
meanAngle (const std::vector<Eigen::Vector3d>& normals, const Mesh& mesh)
{
  return meanAngle (normals, vertexNormals (mesh));
}

double
meanAngle (const std::vector<Eigen::Vector3d>& normals, const std::vector<Eigen::Vector3d>& expected)
{
  std::vector<double> angles;
  for (std::size_t i = 0; i < normals.size (); ++i) {
    // atan2 is accurate for small angles, unlike acos of a cosine near 1.
    const double cosine = std::abs (normals[i].dot (expected[i])), sine = normals[i].cross (expected[i]).norm ();
    angles.push_back (cosine + sine > 0 ? std::atan2 (sine, cosine) * 180 / M_PI : std::nan (""));
  }
  return meanOf (angles);
}
} // namespace tools
} // namespace pcl_normal_smoothing
