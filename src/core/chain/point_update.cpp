// SPDX-License-Identifier: BSD-3-Clause
#include "../search/node_blocks.h"
#include <pcl_normal_smoothing/core/chain/point_update.h>
#include <pcl_normal_smoothing/core/error.h>

#include <string>

namespace pcl_normal_smoothing
{
namespace core
{
void
check (const PointUpdateOptions& options)
{
  if (options.iterations < 0)
    throw Error ("the number of point iterations is " + std::to_string (options.iterations) + ": give 0 or more");
  if (!(options.sigma_s > 0))
    throw Error ("sigma_s of the point update is " + numberText (options.sigma_s) + ": give a number above 0");
  if (!(options.max_displacement > 0))
    throw Error ("the maximal displacement is " + numberText (options.max_displacement) + ": give a length above 0");
  if (options.search_interval < 0)
    throw Error ("the search interval is " + std::to_string (options.search_interval) + ": give 0 or more");
}

PointUpdateOptions
PointUpdateOptions::inUnit (double unit) const
{
  PointUpdateOptions options = *this;
  options.max_displacement = static_cast<float> (max_displacement / unit);
  return options;
}

void
updatePoints (NeighborGraph::ConstPtr graph,
              const Vectors& normals,
              const PointUpdateOptions& options,
              const SearchAgain& search_again,
              const Execution& execution,
              Positions& positions)
{
  if (options.iterations == 0 || graph->size () == 0)
    return;
  const Vectors start = startOf (positions);
  Vectors moved (graph->size ());
  PointUpdateStep step {};
  step.start = start.empty () ? nullptr : start.data ()->data ();
  step.kind = options.rule == UpdateRule::PAPER ? UpdateKind::PAPER : UpdateKind::COMPENSATED;
  step.reach_scale = 1;
  step.normal_factor = 1 / (2 * options.sigma_s * options.sigma_s);
  step.oriented = options.oriented;
  step.all_normals = haveAllNormals (normals);
  step.max_displacement = options.max_displacement;
  for (int iteration = 0; iteration < options.iterations; ++iteration) {
    if (options.search_interval > 0 && iteration > 0 && iteration % options.search_interval == 0)
      graph = search_again (positions);
    step.nodes = nodeArrays (positions, normals);
    step.moved = moved.data ()->data ();
    forEachBlock (*graph, execution.part (iteration, iteration + 1, options.iterations),
                  [&] (const BlockRows& rows) { kernels ().update_points (step, rows); });
    positions.offset.swap (moved);
  }
}
} // namespace core
} // namespace pcl_normal_smoothing
