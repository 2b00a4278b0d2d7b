// SPDX-License-Identifier: BSD-3-Clause
#include "../nodes_where.h"
#include "../quantile.h"

#include "neighborhood_widening.h"

#include "../search/thinned_cloud.h"
#include "quadric_projection.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
bool
haveOneLength (const NeighborGraph& graph)
{
  const std::size_t length = graph.minRowLength ();
  for (std::size_t block = 0; block < graph.blockCount (); ++block)
    if (graph.blockLength (block) != length)
      return false;
  return true;
}

std::vector<int>
halvingsOfNodes (const Widening& widening, const Positions& nodes, const Execution& execution)
{
  std::vector<int> halvings (nodes.size ());
  const int most = ThinnedCloud::mostHalvings (nodes.size (), ThinnedCloud::least_size);
  parallelFor (nodes.size (), execution, [&] (std::size_t begin, std::size_t end) {
    for (std::size_t node = begin; node < end; ++node)
      halvings[node] =
          std::min (most, static_cast<int> (std::lround (widening.halvings ().valueAt (nodes.base[node], 0))));
  });
  return halvings;
}

/** They are a step of the rounding apart. */
bool
areOfRounding (const LayerEstimate& layers, const CoordinateRounding& rounding)
{
  constexpr float most_steps = 1.5f;
  return layers.hasLayers () && quantile (layers.steps.values (), .5) < most_steps * rounding.step;
}
} // namespace

NoiseHiddenBy
Widening::hiddenBy () const
{
  if (areOfRounding (layers, rounding))
    return NoiseHiddenBy::ROUNDING;
  if (layers.hasLayers ())
    return NoiseHiddenBy::LAYERS;
  if (lines.hasLines ())
    return NoiseHiddenBy::LINES;
  if (isNeeded () || projects ())
    return NoiseHiddenBy::WIDTH;
  return rounding.is_seen ? NoiseHiddenBy::ROUNDING : NoiseHiddenBy::NOTHING;
}

Widening
estimateWidening (const NeighborGraph& graph, const Positions& nodes, const Execution& execution)
{
  Widening widening;
  widening.rounding = estimateRounding (graph, nodes, execution);
  if (!haveOneLength (graph))
    return widening;
  widening.layers = estimateLayers (graph, nodes, execution);
  if (!widening.isNeeded ())
    widening.lines = estimateLines (graph, nodes, execution);
  if (!widening.isNeeded ())
    widening.wide_noise = estimateWideNoise (graph, nodes, execution);
  return widening;
}

NeighborGraph::Ptr
widenNeighborhoods (const NeighborGraph& graph,
                    const Positions& nodes,
                    const Widening& widening,
                    const Execution& execution)
{
  if (!widening.isNeeded () || widening.projects () || !haveOneLength (graph))
    return {};
  const Execution still = execution.still ();
  const std::vector<int> halvings = halvingsOfNodes (widening, nodes, still);
  const auto length = static_cast<std::uint32_t> (graph.minRowLength ());
  auto wide = std::make_shared<NeighborGraph> (graph);
  const int most = *std::max_element (halvings.begin (), halvings.end ());
  for (int of_cloud = 1; of_cloud <= most; ++of_cloud) {
    const std::vector<std::uint32_t> changed =
        nodesWhere (nodes.size (), [&] (std::uint32_t node) { return halvings[node] == of_cloud; });
    if (changed.empty ())
      continue;
    const ThinnedCloud thinned (graph, nodes, of_cloud, ThinnedCloud::Parts::ALL, still);
    std::vector<std::uint32_t> rows (changed.size () * length);
    parallelFor (changed.size (), still, [&] (std::size_t begin, std::size_t end) {
      KdTree::Scratch scratch;
      for (std::size_t i = begin; i < end; ++i)
        thinned.row (changed[i], rows.data () + i * length, length, scratch);
    });
    wide = wide->withRows (changed, rows, length);
  }
  return wide;
}

NeighborGraph::Ptr
projectNodes (const NeighborGraph& graph, const Widening& widening, const Execution& execution, Positions& nodes)
{
  if (!widening.projects ())
    return {};
  const Execution still = execution.still ();
  projectOntoQuadrics (graph, widening.wide_noise.ratios, still, nodes);
  return graph.rebuild (nodes, {static_cast<std::uint32_t> (graph.minRowLength ())}, still);
}
} // namespace core
} // namespace pcl_normal_smoothing
