// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/search/neighbor_graph.h>
#include <pcl_normal_smoothing/core/variants.h>

#include <limits>

namespace pcl_normal_smoothing
{
namespace core
{
struct PointUpdateOptions
{
  UpdateRule rule = UpdateRule::COMPENSATED;
  /** sigma_s of eq. 9, the standard deviation of 1 - |n_i.n_j|, above 0. */
  float sigma_s = 0.03f;
  /** Normals are consistently oriented: the signed n_i.n_j is used. */
  bool oriented = false;
  int iterations = 0;
  /** Upper bound on the distance of a point from its start, in the unit of the positions. */
  float max_displacement = std::numeric_limits<float>::infinity ();
  /** Neighbours are searched again after this many iterations; 0: never. */
  int search_interval = 0;

  /** The same options for positions in another unit: see Positions::unit. */
  PointUpdateOptions
  inUnit (double unit) const;
};

/** \throw Error if an option is out of range */
void
check (const PointUpdateOptions& options);

/** Searches the neighbours of nodes that have moved. */
using SearchAgain = std::function<NeighborGraph::ConstPtr (const Positions&)>;

/** Runs options.iterations iterations of eq. 8 with the weights of eq. 9.
  * \param[in,out] positions of the nodes; their offsets change. A node without a normal (NaN) stays and is skipped.
  * \param[in] search_again called every options.search_interval iterations; not used if that is 0 */
void
updatePoints (NeighborGraph::ConstPtr graph,
              const Vectors& normals,
              const PointUpdateOptions& options,
              const SearchAgain& search_again,
              const Execution& execution,
              Positions& positions);
} // namespace core
} // namespace pcl_normal_smoothing
