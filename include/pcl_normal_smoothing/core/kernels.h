// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace pcl_normal_smoothing
{
namespace core
{
/** A block of 16 nodes: see NeighborGraph::blockRows. */
struct BlockRows
{
  const std::uint32_t* neighbors;
  std::size_t length;
};

/** Vectors of three floats of all nodes. */
struct NodeArrays
{
  const float* base;
  const float* offset;
  const float* normals;
};

/** One iteration of the normal filter: see core/normal_filter.h. */
struct NormalFilterStep
{
  NodeArrays nodes;
  const float* distance_factor; // 1 / (2 sigma_c^2) of every node
  int weight;                   // NormalWeight
  float threshold;
  float normal_factor;          // 1 / (2 sigma_s^2)
  bool rms;                     // MixedThreshold::RMS
  bool oriented;
  float* filtered;              // out
};

/** One iteration of the point update: see core/point_update.h. */
struct PointUpdateStep
{
  NodeArrays nodes;
  const float* start; // offsets before the first iteration
  bool compensated;
  float normal_factor; // 1 / (2 sigma_s^2)
  bool oriented;
  float max_displacement;
  float* moved; // out: offsets
};

/** Points that may be neighbours; coordinates as in Positions, arrays readable up to a multiple of 16. */
struct Candidates
{
  const float* base[3];
  const float* offset[3]; // null where all are zero
  std::size_t count;
};

/** A point and what its neighbours must not be farther than. */
struct CandidateQuery
{
  float base[3];
  float offset[3];
  float sq_bound;
};

/** The inner loops, compiled for one instruction set. The results are the same, bit for bit, with every one of them. */
struct Kernels
{
  const char* name;
  void (*distance_factors) (const NodeArrays& nodes, const BlockRows& rows, float* factors);
  void (*filter_normals) (const NormalFilterStep& step, const BlockRows& rows);
  void (*update_points) (const PointUpdateStep& step, const BlockRows& rows);
  /** Numbers of the candidates within the bound. Both outputs hold candidates.count elements, up to a multiple of 16. */
  std::size_t (*select_near) (const Candidates& candidates,
                              const CandidateQuery& query,
                              float* sq_dists,
                              std::uint32_t* selected);
  /** How many keys are smaller than each. Both arrays have room up to a multiple of 16. */
  void (*rank_keys) (const float* keys, std::size_t count, std::int32_t* ranks);
};

/** The kernels for this processor. */
const Kernels&
kernels ();

/** All that this processor can run, the best first; the last runs everywhere.
  * \param[out] count how many */
const Kernels* const*
allKernels (std::size_t& count);
} // namespace core
} // namespace pcl_normal_smoothing
