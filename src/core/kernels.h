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
  std::size_t begin = 0;       // of the block where all blocks keep something for every neighbour
  std::size_t pairs_begin = 0; // of the block where all blocks keep one byte for two neighbours
};

/** Vectors of three floats of all nodes. */
struct NodeArrays
{
  const float* base;
  const float* offset;  // null where all are zero
  const float* normals; // null for kernels that read none
};

/** Computes a number of every node. */
struct NumberOfNodes
{
  NodeArrays nodes;
  float* numbers; // out
};

/** Weighs every neighbour by its distance: see core/chain/normal_filter.h. */
struct DistanceWeights
{
  NodeArrays nodes;
  std::uint16_t* weights; // out: exp (-d^2 / (2 sigma_c^2)) in units of 1 / 65535; 0 behind the end of a row
};

/** Computes a normal of every node. */
struct NormalOfNodes
{
  NodeArrays nodes;
  float* normals; // out
};

/** Gives every node the best supported of the normals around: see core/sheets/sheet_separation.h. */
struct NormalVoteStep
{
  NodeArrays nodes;
  float height_factor; // 1 / (2 sigma^2) of the distance from a candidate's plane
  float agreement;     // how much a neighbour's normal counts against its position; 0: not at all
  float* elected;      // out
};

/** Counts the neighbours of every node that lie on another sheet: see core/sheets/sheet_separation.h. */
struct OtherSheetTest
{
  NodeArrays nodes;
  float sq_distance; // that a neighbour must exceed,
  float sq_slope;    // and this times the square of the way to it more
  float min_cosine;  // between the normals
  bool oriented;     // an opposite normal is enough
  float* others;     // out
};

/** One iteration of the normal filter: see core/chain/normal_filter.h. */
struct NormalFilterStep
{
  NodeArrays nodes;
  const std::uint16_t* distance_weights; // of all neighbours; null for NormalWeight::THRESHOLD
  NormalWeight weight;
  float threshold;     // of NormalWeight::THRESHOLD
  float normal_factor; // 1 / (2 sigma_s^2)
  MixedThreshold mixed_threshold;
  bool oriented;
  bool all_normals; // no node is without one
  float* filtered;  // out
};

/** Along what a neighbour moves a point, and by what it weighs. */
enum class UpdateKind
{
  PAPER,       // its normal; by its distance and normal: UpdateRule::PAPER
  COMPENSATED, // the mean of both normals; by the same: UpdateRule::COMPENSATED
  ROBUST       // the mean of both normals; by its height too: the rounds
};

/** One iteration of the point update: see core/chain/point_update.h. */
struct PointUpdateStep
{
  NodeArrays nodes;
  const float* start; // offsets before the first iteration; null where all are zero
  UpdateKind kind;
  float reach_scale;             // of 1 / (2 sigma_c^2)
  const float* reach_factors;    // of that, of all nodes; null: 1
  float normal_factor;           // 1 / (2 sigma_s^2)
  float residual_factor;         // of UpdateKind::ROBUST: 1 / (2 sigma^2) of the height
  const float* variance_factors; // of the noise, of all nodes; null: 1
  bool oriented;
  bool all_normals; // no node is without one
  float max_displacement;
  float* moved; // out: offsets
};

/** The most neighbours that project_points looks at. */
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
  bool turn_frame; // to the first fit
  bool by_normal;  // neighbours weigh by their normal too
  bool oriented;
  float residual_factor;         // 1 / (2 sigma^2) of the distance from the last fit
  const float* variance_factors; // of the noise, of all nodes; null: 1
  float ridge;
  float* fitted; // out
};

// How much of a proposed step to take, in four tasks, each of all nodes before the next: see
// core/rounds/robust_smoothing.h.

/** What a step may cost. */
struct StepGain
{
  float usual;
  const float* factors; // of all nodes; null: 1
};

/** Tells what the proposed steps risk. */
struct StepRisks
{
  NodeArrays nodes;
  const float* proposed; // offsets
  const float* moved;    // along the normals since the first round
  StepGain gain;
  float* risks; // out: two numbers a node
};

/** Weighs every neighbour for the averages. */
struct AveragingWeights
{
  NodeArrays nodes;
  bool oriented;
  std::uint8_t* weights; // out: of all neighbours, from 0 to 15, two a byte
};

/** Averages the risks over the neighbourhoods, once. */
struct RiskAverages
{
  const std::uint8_t* weights; // of AveragingWeights
  const float* risks;          // two numbers a node
  float* averaged;             // out: the same
};

/** Takes as much of every step as its risk allows. */
struct StepsToTake
{
  NodeArrays nodes;
  const float* start;    // offsets before the first round; null where all are zero
  const float* proposed; // offsets
  const float* risks;    // averaged: two numbers a node
  StepGain gain;
  float max_displacement;
  float* moved; // in and out: along the normals since the first round; null in that one, which does not count
  float* taken; // out: offsets; may be the proposed ones
};

/** Moves points along the surface that came too close to each other: see core/rounds/robust_smoothing.h. */
struct KeepApartStep
{
  NodeArrays nodes;
  const float* start; // offsets before the first round; null where all are zero
  bool oriented;
  float max_displacement;
  float* moved; // out: offsets
};

/** Of a far row, with the node itself. */
constexpr std::size_t far_row_length = 16;

/** The rank, in a row of that length, of the neighbour that a slot of a far row goes on from; 0, which is the node
  * itself, where the row is too short. */
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
  const std::uint8_t* row_lengths;        // of all nodes, 32 at most
  std::uint8_t* ranks;                    // out: block_size far_row_length of every block
};

/** Lets block_size triples of points vote for the normals of their planes: see core/chain/hough.h. */
struct PlaneVotes
{
  const float* points;                        // vectors of three floats
  const std::uint32_t (*triples)[block_size]; // the first points, the second ones, the third ones
  const float (*rotation)[3];
  const float* band_cosine; // of the angle from the pole at which every band ends
  const float* band_begin;  // first bin of every band, then the number of bins
  std::uint32_t bands;
  float (*normals)[block_size]; // out: x, y, z
  std::int32_t* bins;           // out; -1 where three points span no plane
};

/** Points that may be neighbours; coordinates as in Positions, arrays readable up to a multiple of block_size. */
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
  void (*distance_weights) (const DistanceWeights& task, const BlockRows& rows);
  void (*filter_normals) (const NormalFilterStep& step, const BlockRows& rows);
  void (*update_points) (const PointUpdateStep& step, const BlockRows& rows);
  void (*start_normals) (const NormalOfNodes& normals, const BlockRows& rows);
  void (*elect_normals) (const NormalVoteStep& step, const BlockRows& rows);
  void (*count_others) (const OtherSheetTest& test, const BlockRows& rows);
  void (*residual_variances) (const NumberOfNodes& variances, const BlockRows& rows);
  void (*project_points) (const QuadricProjection& projection, const BlockRows& rows);
  void (*fit_normals) (const QuadricFitStep& step, const BlockRows& rows);
  void (*step_risks) (const StepRisks& task, const BlockRows& rows);
  void (*averaging_weights) (const AveragingWeights& task, const BlockRows& rows);
  void (*average_risks) (const RiskAverages& task, const BlockRows& rows);
  void (*take_steps) (const StepsToTake& task, const BlockRows& rows);
  void (*keep_apart) (const KeepApartStep& step, const BlockRows& rows);
  void (*find_far_rows) (const FarRowsStep& step, const BlockRows& rows);
  void (*vote_planes) (const PlaneVotes& votes);
  /** The candidates within the bound: their numbers and squared distances. Both outputs have room for candidates.count
    * and block_size more. */
  std::size_t (*select_near) (const Candidates& candidates,
                              const CandidateQuery& query,
                              float* sq_dists,
                              std::uint32_t* selected);
  /** How many keys are smaller than each; whether all differ. Both arrays have room for block_size more. */
  bool (*rank_keys) (const float* keys, std::size_t count, std::int32_t* ranks);
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
