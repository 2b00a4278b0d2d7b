// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/search/neighbor_graph.h>
#include <pcl_normal_smoothing/core/variants.h>

namespace pcl_normal_smoothing
{
namespace core
{
struct NormalFilterOptions
{
  NormalWeight weight = NormalWeight::GAUSSIAN;
  /** T of eq. 3, a cosine in [0, 1). */
  float threshold = 0.65f;
  /** sigma_s of eq. 5, the standard deviation of |n_i - n_j|, above 0. */
  float sigma_s = 0.3f;
  MixedThreshold mixed_threshold = MixedThreshold::PRINTED;
  /** Normals are consistently oriented: none is flipped. */
  bool oriented = false;
  int iterations = 0;
};

/** \throw Error if an option is out of range */
void
check (const NormalFilterOptions& options);

/** Runs options.iterations iterations of eq. 2: a node's normal becomes the weighted sum of the normals of its
  * neighbourhood, itself included, normalised. A normal at more than 90 degrees is flipped, unless the normals are
  * oriented; the sign of the node's own normal stays. Neighbours without a normal (NaN) do not count; if the sum
  * vanishes, or the node has no normal, the old one stays. sigma_c of eq. 5 is the mean distance to the other points.
  * \param[in] positions of the nodes
  * \param[in,out] normals of the nodes, of unit length or NaN */
void
filterNormals (const NeighborGraph& graph,
               const Positions& positions,
               const NormalFilterOptions& options,
               const Execution& execution,
               Vectors& normals);
} // namespace core
} // namespace pcl_normal_smoothing
