// SPDX-License-Identifier: BSD-3-Clause
#include "sheet_normals.h"

#include "../nodes_where.h"

#include "../search/node_blocks.h"
#include "sheet_criterion.h"

#include <algorithm>
#include <limits>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
constexpr std::size_t start_k = 8;
constexpr float agreement = 2;

NormalVoteStep
voteAmong (const Positions& positions, const Vectors& candidates, float distance, Vectors& elected)
{
  NormalVoteStep step {};
  step.nodes = nodeArrays (positions, candidates);
  // exp (-h^2 / (2 (distance / 2)^2)) of a height h.
  step.height_factor = 2 / std::max (distance * distance, std::numeric_limits<float>::min () * 1e8f);
  step.elected = elected.data ()->data ();
  return step;
}
} // namespace

std::vector<std::uint32_t>
nodesInRows (const NeighborGraph& graph, const std::vector<std::uint32_t>& nodes, std::size_t max_length)
{
  std::vector<bool> is_in (graph.size ());
  for (const std::uint32_t node : nodes) {
    const Row row = graph.row (node);
    for (std::size_t j = 0; j < std::min (row.size (), max_length); ++j)
      is_in[row[j]] = true;
  }
  return nodesWhere (graph.size (), [&] (std::uint32_t node) { return is_in[node]; });
}

Vectors
electNormals (const NeighborGraph& graph,
              const Positions& positions,
              const SheetScale& by,
              const std::vector<std::uint32_t>* nodes,
              const Execution& execution)
{
  std::vector<std::uint32_t> candidates_of;
  if (nodes != nullptr)
    candidates_of = nodesInRows (graph, *nodes, by.row_length);
  Vectors candidates (graph.size ()), elected (graph.size ());
  const StartNormals start {nodeArrays (positions), candidates.data ()->data ()};
  forEachBlockOf (graph, nodes != nullptr ? &candidates_of : nullptr, start_k, execution,
                  [&] (const BlockRows& rows) { kernels ().start_normals (start, rows); });
  const NormalVoteStep vote = voteAmong (positions, candidates, by.distance, elected);
  forEachBlockOf (graph, nodes, by.row_length, execution,
                  [&] (const BlockRows& rows) { kernels ().elect_normals (vote, rows); });
  return elected;
}

Vectors
electAgain (const NeighborGraph& graph,
            const Positions& positions,
            float distance,
            const Vectors& normals,
            const std::vector<std::uint32_t>& nodes,
            const Execution& execution)
{
  Vectors elected = normals;
  NormalVoteStep vote = voteAmong (positions, normals, distance, elected);
  vote.agreement = agreement;
  forEachBlockOf (graph, nodes, sheet_row_length, execution,
                  [&] (const BlockRows& rows) { kernels ().elect_normals (vote, rows); });
  return elected;
}
} // namespace core
} // namespace pcl_normal_smoothing
