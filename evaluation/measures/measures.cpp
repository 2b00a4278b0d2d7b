// SPDX-License-Identifier: BSD-3-Clause
#include "measures/measures.h"

#include "measures/sharp_edges.h"
#include "meshes/mesh_measures.h"
#include "meshes/smoothing_error.h"

#include <pcl_normal_smoothing/core/error.h>
#include <pcl_normal_smoothing/core/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl_normal_smoothing::evaluation
{
namespace
{
constexpr double sharp_degrees = 30, edge_reach = 0.5, off_surface = 0.1; // lengths in mean edge lengths

/** Calls \a function for every point, on all threads, and collects the results. */
template <typename Function>
std::vector<double>
forPoints (std::size_t count, const Function& function)
{
  std::vector<double> result (count);
  core::parallelFor (count, core::Execution (), [&] (std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      result[i] = function (i);
  });
  return result;
}

double
mean (const std::vector<double>& numbers)
{
  return std::accumulate (numbers.begin (), numbers.end (), 0.0) / static_cast<double> (numbers.size ());
}

/** Over the points that have a surface variation in both clouds. */
double
meanDifference (const std::vector<double>& a, const std::vector<double>& b)
{
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size (); ++i)
    if (const double difference = std::abs (a[i] - b[i]); !std::isnan (difference)) {
      sum += difference;
      ++count;
    }
  return sum / static_cast<double> (count);
}

/** The value below which one hundredth of the numbers lie. */
double
firstPercentile (std::vector<double> numbers)
{
  const auto at = numbers.begin () + static_cast<std::ptrdiff_t> (numbers.size () / 100);
  std::nth_element (numbers.begin (), at, numbers.end ());
  return *at;
}
} // namespace

Evaluator::Evaluator (const Model& model)
: model_ (model)
, mean_edge_ (tools::meanEdgeLength (model.mesh))
, mesh_distance_ (model.mesh)
, vertex_normals_ (tools::vertexNormals (model.mesh))
, clean_ (findNeighborhoods (model.mesh.vertices))
, near_edges_ (verticesNearSharpEdges (model.mesh, sharp_degrees, edge_reach * mean_edge_))
{}

void
Evaluator::check (const tools::Points& points) const
{
  if (points.size () != model_.mesh.vertices.size ())
    throw core::Error (std::to_string (points.size ()) + " points came out, " +
                       std::to_string (model_.mesh.vertices.size ()) + " went in");
  for (std::size_t i = 0; i < points.size (); ++i)
    if (!points[i].allFinite ())
      throw core::Error ("point " + std::to_string (i) + " is not finite");
}

void
Evaluator::setNoisy (const tools::Points& noisy)
{
  noisy_ = measure (noisy, {}, MeasureSet::ALL);
  noisy_spacing_ = firstPercentile (findNeighborhoods (noisy).spacings);
}

Measures
Evaluator::measure (const tools::Points& points, const tools::Points& normals, MeasureSet set) const
{
  check (points);
  Measures measures;
  measures.area_error = tools::areaError (points, model_.mesh);
  const Neighborhoods neighborhoods = findNeighborhoods (points);
  measures.variation_error_7 = meanDifference (neighborhoods.variations[0], clean_.variations[0]);
  measures.variation_error_15 = meanDifference (neighborhoods.variations[1], clean_.variations[1]);
  measures.variation_error_21 = meanDifference (neighborhoods.variations[2], clean_.variations[2]);
  if (set == MeasureSet::PAPER)
    return measures;
  measureDistances (points, measures);
  measures.normal_angle = tools::meanAngle (neighborhoods.normals, vertex_normals_);
  if (!normals.empty ())
    measures.own_normal_angle = tools::meanAngle (normals, vertex_normals_);
  measures.spacing_p01 = firstPercentile (neighborhoods.spacings) / noisy_spacing_;
  return measures;
}

void
Evaluator::measureDistances (const tools::Points& points, Measures& measures) const
{
  const tools::Points& clean = model_.mesh.vertices;
  const std::vector<double> distances =
      forPoints (points.size (), [&] (std::size_t i) { return mesh_distance_ (points[i], clean[i]) / mean_edge_; });
  measures.p2s_mean = mean (distances);
  measures.p2s_rms = std::sqrt (std::inner_product (distances.begin (), distances.end (), distances.begin (), 0.0) /
                                double (distances.size ()));
  measures.p2s_max = *std::max_element (distances.begin (), distances.end ());
  measures.p2s_ratio = measures.p2s_mean / noisy_.p2s_mean;
  measures.p2p_mean =
      mean (forPoints (points.size (), [&] (std::size_t i) { return (points[i] - clean[i]).norm () / mean_edge_; }));
  measures.p2p_ratio = measures.p2p_mean / noisy_.p2p_mean;
  measureEdges (distances, measures);
  if (!model_.surface_distance)
    return;
  measures.exact_mean = mean (
      forPoints (points.size (), [&] (std::size_t i) { return model_.surface_distance (points[i]) / mean_edge_; }));
  measures.exact_ratio = measures.exact_mean / noisy_.exact_mean;
}

void
Evaluator::measureEdges (const std::vector<double>& distances, Measures& measures) const
{
  if (near_edges_.empty ())
    return;
  double sum = 0, off = 0;
  for (const std::uint32_t i : near_edges_) {
    sum += distances[i];
    off += distances[i] > off_surface ? 1 : 0;
  }
  measures.edge_error = sum / static_cast<double> (near_edges_.size ());
  measures.edge_fraction = off / static_cast<double> (near_edges_.size ());
}

} // namespace pcl_normal_smoothing::evaluation
