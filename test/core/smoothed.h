// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "graph_rows.h"
#include "searched.h"

#include <core/whole_cloud.h>

#include <gtest/gtest.h>

namespace test_support
{
struct Smoothed
{
  Vectors displacements;
  Vectors normals;
};

/** The rounds of the presets default and fast, with noise and sheet distance to be estimated; the noise is taken as
  * even, and neighbourhoods do not grow. */
inline pcl_normal_smoothing::core::SmoothingOptions
robustOptions (bool fast)
{
  pcl_normal_smoothing::core::SmoothingOptions options;
  options.in_rounds = true;
  options.rounds.noise = {-1, -1};
  options.rounds.fast = fast;
  options.rounds.count = fast ? 3 : 6;
  options.rounds.sheet_distance = -1;
  return options;
}

/** The same with noise that may vary and neighbourhoods that may grow, the defaults. */
inline pcl_normal_smoothing::core::SmoothingOptions
wideningOptions (bool fast)
{
  pcl_normal_smoothing::core::SmoothingOptions options = robustOptions (fast);
  options.noise_varies = options.widen_neighborhoods = true;
  return options;
}

/** Number of neighbours that the preset uses. */
inline std::uint32_t
neighborsOf (bool fast)
{
  return fast ? 16 : 32;
}

/** The options completed with estimates from the cloud. */
inline pcl_normal_smoothing::core::SmoothingOptions
prepared (pcl_normal_smoothing::core::SmoothingOptions options, const Searched& cloud)
{
  using namespace pcl_normal_smoothing::core;
  NeighborGraph::ConstPtr graph = cloud.graph;
  MovingSurface surface (cloud.nodes);
  prepareSmoothing (Execution (2), graph, options, surface);
  return options;
}

/** What hides the noise of the points; expects the noise estimate and the smoothing to agree on it. */
inline pcl_normal_smoothing::core::NoiseHiddenBy
noiseHiddenBy (const Vectors& points)
{
  using namespace pcl_normal_smoothing::core;
  const Searched cloud (points);
  const NoiseHiddenBy estimated = estimateNoise (*cloud.graph, cloud.nodes, Execution (2)).hidden_by;
  EXPECT_EQ (prepared (wideningOptions (false), cloud).rounds.noise.hidden_by, estimated);
  return estimated;
}

/** Runs the whole method; results are in the order of the cloud.
  * \param[in] normals for NormalSource::INPUT */
inline Smoothed
smoothed (const Positions& cloud,
          std::uint32_t k,
          pcl_normal_smoothing::core::SmoothingOptions options,
          const Vectors& normals = {},
          unsigned threads = 2)
{
  using namespace pcl_normal_smoothing::core;
  const Execution execution (threads);
  NeighborGraph::ConstPtr graph = NeighborGraph::build (cloud, {k}, execution);
  MovingSurface surface (gather (cloud, graph->order ()), normals.empty () ? Vectors () : byNode (normals, *graph));
  prepareSmoothing (execution, graph, options, surface);
  const SearchAgain search_again = [&] (const Positions& moved) { return graph->rebuild (moved, {k}, execution); };
  smooth (graph, options, search_again, execution, surface);
  return {byPoint (surface.displacements (), *graph), byPoint (surface.normals, *graph)};
}

inline Vectors
sum (Vectors points, const Vectors& displacements)
{
  for (std::size_t i = 0; i < points.size (); ++i)
    points[i] += displacements[i];
  return points;
}
} // namespace test_support
