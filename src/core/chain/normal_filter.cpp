// SPDX-License-Identifier: BSD-3-Clause
#include "../search/node_blocks.h"
#include <pcl_normal_smoothing/core/chain/normal_filter.h>
#include <pcl_normal_smoothing/core/error.h>

#include <string>

namespace pcl_normal_smoothing
{
namespace core
{
void
check (const NormalFilterOptions& options)
{
  if (options.iterations < 0)
    throw Error ("the number of normal iterations is " + std::to_string (options.iterations) + ": give 0 or more");
  if (!(options.threshold >= 0 && options.threshold < 1))
    throw Error ("the threshold T of eq. 3 is " + numberText (options.threshold) +
                 ": give a cosine of at least 0 and below 1");
  if (!(options.sigma_s > 0))
    throw Error ("sigma_s of the normal filter is " + numberText (options.sigma_s) + ": give a number above 0");
}

void
filterNormals (const NeighborGraph& graph,
               const Positions& positions,
               const NormalFilterOptions& options,
               const Execution& execution,
               Vectors& normals)
{
  if (options.iterations == 0 || graph.size () == 0)
    return;
  const bool by_distance = options.weight != NormalWeight::THRESHOLD;
  PaddedVector<std::uint16_t> distance_weights (by_distance ? graph.blockBegin (graph.blockCount ()) : 0);
  Vectors filtered (graph.size ());
  NormalFilterStep step {};
  step.distance_weights = distance_weights.data ();
  step.weight = options.weight;
  step.threshold = options.threshold;
  step.normal_factor = 1 / (2 * options.sigma_s * options.sigma_s);
  step.mixed_threshold = options.mixed_threshold;
  step.oriented = options.oriented;
  step.all_normals = haveAllNormals (normals);
  for (int iteration = 0; iteration < options.iterations; ++iteration) {
    step.nodes = nodeArrays (positions, normals);
    step.filtered = filtered.data ()->data ();
    forEachBlock (graph, execution.part (iteration, iteration + 1, options.iterations), [&] (const BlockRows& rows) {
      if (iteration == 0 && by_distance)
        kernels ().distance_weights ({step.nodes, distance_weights.data ()}, rows);
      kernels ().filter_normals (step, rows);
    });
    normals.swap (filtered);
  }
}
} // namespace core
} // namespace pcl_normal_smoothing
