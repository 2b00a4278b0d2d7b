// SPDX-License-Identifier: BSD-3-Clause
#include "measures/neighborhoods.h"

#include <pcl_normal_smoothing/core/chain/local_surface.h>
#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

#include <algorithm>

namespace pcl_normal_smoothing::evaluation
{
namespace
{
constexpr std::size_t size_of_normals = 1; // index of 15 in neighborhood_sizes

/** Splits coordinates into base and offset as readPositions does. */
core::Positions
positionsOf (const tools::Points& points, const core::Execution& execution)
{
  core::Positions positions {core::Vectors (points.size ()), core::Vectors (points.size ())};
  core::parallelFor (points.size (), execution, [&] (std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      positions.base[i] = points[i].cast<float> ();
      positions.offset[i] = (points[i] - positions.base[i].cast<double> ()).cast<float> ();
    }
  });
  return positions;
}

/** Rows are sorted by distance, so the smaller neighbourhoods are the first entries of a row. */
void
lookAround (const core::NeighborGraph& graph, const core::Positions& nodes, std::size_t node, Neighborhoods& result)
{
  const std::uint32_t point = graph.order ()[node];
  const core::Row row = graph.row (node);
  const std::uint32_t* first = graph.blockRows (node / core::block_size) + node % core::block_size;
  for (std::size_t s = 0; s < neighborhood_sizes.size (); ++s) {
    const core::Row part (first, std::min<std::size_t> (row.size (), neighborhood_sizes[s]), core::block_size);
    const core::LocalSurface surface = core::pcaSurface ({nodes, nodes.base[node], nodes.offset[node], part});
    result.variations[s][point] = surface.variation;
    if (s == size_of_normals)
      result.normals[point] =
          surface.normal.allFinite () ? Eigen::Vector3d (surface.normal.cast<double> ()) : Eigen::Vector3d (0, 0, 0);
  }
  if (row.size () > 1)
    result.spacings[point] = nodes.difference (static_cast<std::uint32_t> (node), row[1]).cast<double> ().norm ();
}
} // namespace

Neighborhoods
findNeighborhoods (const tools::Points& points)
{
  const core::Execution execution;
  const core::Positions cloud = positionsOf (points, execution);
  core::NeighborQuery query;
  query.k = neighborhood_sizes.back ();
  const auto graph = core::NeighborGraph::build (cloud, query, execution);
  const core::Positions nodes = core::gather (cloud, graph->order (), execution);
  Neighborhoods result;
  for (std::vector<double>& variations : result.variations)
    variations.resize (points.size ());
  result.normals.resize (points.size ());
  result.spacings.resize (points.size ());
  core::parallelFor (graph->size (), execution, [&] (std::size_t begin, std::size_t end) {
    for (std::size_t node = begin; node < end; ++node)
      lookAround (*graph, nodes, node, result);
  });
  return result;
}

} // namespace pcl_normal_smoothing::evaluation
