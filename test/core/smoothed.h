// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "graph_rows.h"

#include <core/whole_cloud.h>

namespace test_support
{
struct Smoothed
{
  Vectors displacements;
  Vectors normals;
};

/** The presets default and fast: rounds, what they need to be estimated, with even noise and neighbourhoods as they
  * are. */
inline pcl_normal_smoothing::core::SmoothingOptions
robustOptions (bool fast)
{
  pcl_normal_smoothing::core::SmoothingOptions options;
  options.robust = true;
  options.rounds.noise = {-1, -1};
  options.rounds.fast = fast;
  options.rounds.rounds = fast ? 3 : 6;
  options.rounds.sheet_distance = -1;
  return options;
}

/** The same with noise that may vary, and neighbourhoods that may grow: as they are by default. */
inline pcl_normal_smoothing::core::SmoothingOptions
wideningOptions (bool fast)
{
  pcl_normal_smoothing::core::SmoothingOptions options = robustOptions (fast);
  options.noise_varies = options.widen_neighborhoods = true;
  return options;
}

/** The whole method, in the order of the cloud.
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
  Positions nodes = gather (cloud, graph->order ());
  const Vectors start = startOf (nodes);
  Vectors of_nodes = normals.empty () ? Vectors () : byNode (normals, *graph);
  prepareSmoothing (of_nodes, execution, graph, options, nodes);
  const SearchAgain search_again = [&] (const Positions& moved) { return graph->rebuild (moved, {k}, execution); };
  smooth (graph, options, search_again, execution, start, nodes, of_nodes);
  return {byPoint (displacements (start, nodes), *graph), byPoint (of_nodes, *graph)};
}

inline Vectors
sum (Vectors points, const Vectors& displacements)
{
  for (std::size_t i = 0; i < points.size (); ++i)
    points[i] += displacements[i];
  return points;
}
} // namespace test_support
