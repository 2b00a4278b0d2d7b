// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/block_size.h>
#include <pcl_normal_smoothing/core/variants.h>

#include <cstddef>
#include <cstdint>

namespace pcl_normal_smoothing
{
namespace core
{
/** A block of nodes: see NeighborGraph::blockRows. */
struct BlockRows
{
  const std::uint32_t* neighbors;
  std::size_t length;
  std::size_t begin = 0;       // index of the block's first entry in arrays with one value per neighbour
  std::size_t pairs_begin = 0; // index of the block's first entry in arrays with one byte per pair of neighbours
};

/** Arrays of three floats per node. */
struct NodeArrays
{
  const float* base;
  const float* offset;  // null where all are zero
  const float* normals; // null for kernels that read none
};

/** Computes the residual variance of a quadric through every neighbourhood: see core/noise/residual_quantiles.h. */
struct QuadricResiduals
{
  NodeArrays nodes;
  float* variances; // out
};

/** Weighs every neighbour by its distance: see core/chain/normal_filter.h. */
struct DistanceWeights
{
  NodeArrays nodes;
  std::uint16_t* weights; // out: exp (-d^2 / (2 sigma_c^2)) in units of 1 / 65535; 0 beyond the end of a row
};

/** Computes the initial normal of every node: see core/rounds/robust_smoothing.h. */
struct StartNormals
{
  NodeArrays nodes;
  float* normals; // out
};

/** Gives every node the best supported of the normals around it: see core/sheets/sheet_separation.h. */
struct NormalVoteStep
{
  NodeArrays nodes;
  float height_factor; // 1 / (2 sigma^2) for the distance from a candidate's plane
  float agreement;     // weight of a neighbour's normal relative to its position; 0: normals are ignored
  float* elected;      // out
};

/** Counts the neighbours of every node that lie on another sheet: see core/sheets/sheet_separation.h. */
struct OtherSheetCount
{
  NodeArrays nodes;
  float sq_distance; // a neighbour is on another sheet if its squared height over the
  float sq_slope;    // tangent plane exceeds sq_distance + sq_slope * (squared distance to it),
  float min_cosine;  // and |cosine| between the normals exceeds this
  bool oriented;     // an opposite normal suffices
  float* others;     // out
};

/** One iteration of the normal filter: see core/chain/normal_filter.h. */
struct NormalFilterStep
{
  NodeArrays nodes;
  const std::uint16_t* distance_weights; // one per neighbour; null for NormalWeight::THRESHOLD
  NormalWeight weight;
  float threshold;     // for NormalWeight::THRESHOLD
  float normal_factor; // 1 / (2 sigma_s^2)
  MixedThreshold mixed_threshold;
  bool oriented;
  bool all_normals; // every node has a normal
  float* filtered;  // out
};

/** The direction in which a neighbour moves a point, and what its weight depends on. */
enum class UpdateKind
{
  PAPER,       // the neighbour's normal; weighted by distance and normal: UpdateRule::PAPER
  COMPENSATED, // the mean of both normals; weighted likewise: UpdateRule::COMPENSATED
  ROBUST       // the mean of both normals; weighted by height too: the rounds
};

/** One iteration of the point update: see core/chain/point_update.h. */
struct PointUpdateStep
{
  NodeArrays nodes;
  const float* start; // offsets before the first iteration; null where all are zero
  UpdateKind kind;
  float reach_scale;             // factor of 1 / (2 sigma_c^2)
  const float* reach_factors;    // further factor per node; null: 1
  float normal_factor;           // 1 / (2 sigma_s^2)
  float residual_factor;         // for UpdateKind::ROBUST: 1 / (2 sigma^2) for the height
  const float* variance_factors; // of the noise, per node; null: 1
  bool oriented;
  bool all_normals; // every node has a normal
  float max_displacement;
  float* moved; // out: offsets
};

/** Upper bound on the neighbours that project_points uses. */
constexpr std::size_t max_projection_neighbors = 128;

/** Moves every node onto a quadric through its neighbours: see core/noise/quadric_projection.h. */
struct QuadricProjection
{
  NodeArrays nodes;
  float* projected; // out: offsets
};

/** One fit of the normals: see core/rounds/robust_smoothing.h. */
struct QuadricFitStep
{
  NodeArrays nodes;
  int solves;
  bool turn_frame; // to the gradient of the first fit
  bool by_normal;  // weight neighbours by their normals too
  bool oriented;
  float residual_factor;         // 1 / (2 sigma^2) for the distance from the previous fit
  const float* variance_factors; // of the noise, per node; null: 1
  float ridge;
  float* fitted; // out
};

// How much of a proposed step to take, in four tasks; each is completed for all nodes before the next: see
// core/rounds/robust_smoothing.h.

/** The risk at which a step is refused: sigma^2 K of doc/robust_smoothing.md, times a tolerance. */
struct RiskLimit
{
  float usual;
  const float* factors; // per node; null: 1
};

/** Computes the risk of the proposed steps. */
struct StepRisks
{
  NodeArrays nodes;
  const float* proposed; // offsets
  const float* moved;    // distance moved along the normals since the first round
  RiskLimit limit;
  float* risks; // out: two values per node
};

/** Computes the weights of the neighbours in the averages. */
struct AveragingWeights
{
  NodeArrays nodes;
  bool oriented;
  std::uint8_t* weights; // out: from 0 to 15 per neighbour, two in a byte
};

/** Averages the risks over the neighbourhoods, once. */
struct RiskAverages
{
  const std::uint8_t* weights; // of AveragingWeights
  const float* risks;          // two values per node
  float* averaged;             // out: likewise
};

/** Takes as much of every step as its risk allows. */
struct StepsToTake
{
  NodeArrays nodes;
  const float* start;    // offsets before the first round; null where all are zero
  const float* proposed; // offsets
  const float* risks;    // averaged: two values per node
  RiskLimit limit;
  float max_displacement;
  float* moved; // in and out: distance moved along the normals since the first round; null in that round
  float* taken; // out: offsets; may be the same array as proposed
};

/** Moves points that came too close to each other apart along the surface: see core/rounds/robust_smoothing.h. */
struct KeepApartStep
{
  NodeArrays nodes;
  const float* start; // offsets before the first round; null where all are zero
  bool oriented;
  float max_displacement;
  float* moved; // out: offsets
};

/** Length of a far row, the node itself included. */
constexpr std::size_t far_row_length = 16;

/** Rank, in a row of that length, of the neighbour from which a slot of a far row continues; 0 (the node itself) if
  * the row is too short. */
constexpr std::size_t
seedRank (std::size_t slot, std::size_t row_length)
{
  return row_length >= far_row_length ? slot * row_length / far_row_length : slot < row_length ? slot : 0;
}

/** Finds rows twice as wide: see core/rounds/far_rows.h. */
struct FarRowsStep
{
  NodeArrays nodes;                       // their normals are not read
  const std::uint32_t* const* block_rows; // of the graph
  const std::uint8_t* row_lengths;        // per node, at most 32
  std::uint8_t* ranks;                    // out: block_size * far_row_length per block
};

/** Lets block_size triples of points vote for the normals of their planes: see core/chain/hough.h. */
struct PlaneVotes
{
  const float* points;                        // vectors of three floats
  const std::uint32_t (*triples)[block_size]; // the first points, then the second, then the third
  const float (*rotation)[3];
  const float* band_cosine; // of the angle from the pole at which each band ends
  const float* band_begin;  // first bin of each band, then the number of bins
  std::uint32_t bands;
  float (*normals)[block_size]; // out: x, y, z
  std::int32_t* bins;           // out; -1 where the three points span no plane
};

/** Potential neighbours; coordinates as in Positions, arrays readable up to a multiple of block_size. */
struct Candidates
{
  const float* base[3];
  const float* offset[3]; // null where all are zero
  std::size_t count;
};

/** A point and an upper bound on the squared distance of its neighbours. */
struct CandidateQuery
{
  float base[3];
  float offset[3];
  float sq_bound;
};

/** The inner loops, compiled for one instruction set. The results are bit for bit the same with each of them. */
struct Kernels
{
  const char* name;
  void (*distance_weights) (const DistanceWeights& task, const BlockRows& rows);
  void (*filter_normals) (const NormalFilterStep& step, const BlockRows& rows);
  void (*update_points) (const PointUpdateStep& step, const BlockRows& rows);
  void (*start_normals) (const StartNormals& normals, const BlockRows& rows);
  void (*elect_normals) (const NormalVoteStep& step, const BlockRows& rows);
  void (*count_others) (const OtherSheetCount& task, const BlockRows& rows);
  void (*residual_variances) (const QuadricResiduals& residuals, const BlockRows& rows);
  void (*project_points) (const QuadricProjection& projection, const BlockRows& rows);
  void (*fit_normals) (const QuadricFitStep& step, const BlockRows& rows);
  void (*step_risks) (const StepRisks& task, const BlockRows& rows);
  void (*averaging_weights) (const AveragingWeights& task, const BlockRows& rows);
  void (*average_risks) (const RiskAverages& task, const BlockRows& rows);
  void (*take_steps) (const StepsToTake& task, const BlockRows& rows);
  void (*keep_apart) (const KeepApartStep& step, const BlockRows& rows);
  void (*find_far_rows) (const FarRowsStep& step, const BlockRows& rows);
  void (*vote_planes) (const PlaneVotes& votes);
  /** Finds the candidates within the bound: their numbers and squared distances. Both outputs need room for
    * candidates.count + block_size. */
  std::size_t (*select_near) (const Candidates& candidates,
                              const CandidateQuery& query,
                              float* sq_dists,
                              std::uint32_t* selected);
  /** For each key, counts the smaller ones; returns whether all keys differ. Both arrays need room for count +
    * block_size. */
  bool (*rank_keys) (const float* keys, std::size_t count, std::int32_t* ranks);
};

/** The kernels for this processor. */
const Kernels&
kernels ();

/** All kernels that this processor can run, the best first; the last runs everywhere.
  * \param[out] count their number */
const Kernels* const*
allKernels (std::size_t& count);
} // namespace core
} // namespace pcl_normal_smoothing
