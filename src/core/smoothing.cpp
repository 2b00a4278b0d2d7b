// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/error.h>
#include <pcl_normal_smoothing/core/smoothing.h>

#include <algorithm>
#include <cmath>

namespace pcl_normal_smoothing
{
namespace core
{
void
smooth (const NeighborGraph::ConstPtr& graph,
        const SmoothingOptions& options,
        const Research& research,
        const Execution& execution,
        Positions& positions,
        Vectors& normals)
{
  if (options.normals != NormalSource::INPUT)
    normals = estimateNormals (*graph, positions, makeEstimator (options.normals, options.hough),
                               execution.part (0, 0.3));
  if (std::all_of (normals.begin (), normals.end (), [] (const auto& n) { return std::isnan (n.x ()); }))
    throw Error ("no point has a normal: every neighbourhood has fewer than 3 points or lies on a line; "
                 "the cloud must sample a surface, with a neighbourhood that holds at least 3 points");
  filterNormals (*graph, positions, options.filter, execution.part (0.3, 0.7), normals);
  updatePoints (graph, normals, options.update, research, execution.part (0.7, 1), positions);
}
} // namespace core
} // namespace pcl_normal_smoothing
