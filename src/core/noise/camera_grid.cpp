// SPDX-License-Identifier: BSD-3-Clause
#include "camera_grid.h"

#include "../quantile.h"

#include "../search/hash_sample.h"

#include <algorithm>
#include <limits>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
constexpr std::size_t sample_size = 512;
constexpr double least_cosine = .6, min_share_before = .99;
constexpr double max_spread_of_pixels = 1.25; // of the quartiles of the distances that should be one pixel

/** Intersection of a point's ray with the plane at distance 1. */
Eigen::Vector3d
pixelOf (const Positions& nodes, std::uint32_t node, const Eigen::Vector3d& axis)
{
  const Eigen::Vector3d point = (nodes.base[node] + nodes.offset[node]).cast<double> ();
  return point / point.dot (axis);
}
} // namespace

Eigen::Vector3d
viewingDirection (const Positions& nodes, const Execution& execution)
{
  std::vector<Eigen::Vector3d> rays;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero ();
  for (const std::uint32_t node : sampleNodes (nodes, sample_size, execution)) {
    rays.push_back (nodes.base[node].cast<double> ().normalized ());
    sum += rays.back ();
  }
  const Eigen::Vector3d direction = sum.normalized ();
  const auto before =
      std::count_if (rays.begin (), rays.end (), [&] (const auto& ray) { return ray.dot (direction) > least_cosine; });
  return static_cast<double> (before) > min_share_before * static_cast<double> (rays.size ())
             ? direction
             : Eigen::Vector3d::Zero ();
}

bool
isGridOfCamera (const NeighborGraph& graph,
                const Positions& nodes,
                const Eigen::Vector3d& axis,
                const Execution& execution)
{
  std::vector<float> pixels;
  for (const std::uint32_t node : sampleNodes (nodes, sample_size, execution)) {
    const Row row = graph.row (node);
    const Eigen::Vector3d own = pixelOf (nodes, node, axis);
    double nearest = std::numeric_limits<double>::infinity ();
    for (std::size_t j = 1; j < row.size (); ++j)
      nearest = std::min (nearest, (pixelOf (nodes, row[j], axis) - own).norm ());
    pixels.push_back (static_cast<float> (nearest));
  }
  return quantile (pixels, .75) < max_spread_of_pixels * quantile (pixels, .25);
}
} // namespace core
} // namespace pcl_normal_smoothing
