// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "graph_rows.h"

#include <core/kernels.h>
#include <core/search/node_blocks.h>
#include <pcl_normal_smoothing/core/chain/normal_filter.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace test_support
{
using namespace pcl_normal_smoothing::core;

inline constexpr float infinity = std::numeric_limits<float>::infinity ();
inline constexpr float nan_float = std::numeric_limits<float>::quiet_NaN ();

/** Compares bit patterns, so equal NaNs are equal. */
template <typename Number>
void
expectSameBits (const std::vector<Number>& actual, const std::vector<Number>& expected, const std::string& kernels)
{
  ASSERT_EQ (actual.size (), expected.size ());
  for (std::size_t i = 0; i < expected.size (); ++i)
    ASSERT_EQ (std::memcmp (&actual[i], &expected[i], sizeof (Number)), 0)
        << kernels << ": number " << i << " is " << actual[i] << ", not " << expected[i];
}

/** Expects the same results for all instruction sets. \param[in] compute maps kernels to a vector of numbers */
template <typename Compute>
void
expectAllTheSame (const Compute& compute)
{
  std::size_t count = 0;
  const Kernels* const* all = allKernels (count);
  ASSERT_GT (count, 0u);
  for (std::size_t i = 0; i + 1 < count; ++i)
    expectSameBits (compute (*all[i]), compute (*all[count - 1]), all[i]->name);
}

/** Clouds with a full or a partly filled last block, with and without offsets, with rows of one or of many lengths, and
  * with some nodes that have no normal. */
class KernelsTest : public testing::TestWithParam<std::tuple<int, NeighborQuery>>
{
protected:
  KernelsTest ()
  {
    const Shape shape = torus (std::get<0> (GetParam ()), 1, 0.4);
    const Positions cloud = asPositions (withNoise (shape.points, 0.05, 120));
    graph_ = NeighborGraph::build (cloud, std::get<1> (GetParam ()), Execution (1));
    nodes_ = gather (cloud, graph_->order ());
    if (shape.points.size () % 2 == 1) // otherwise offsets are zero, and kernels skip them
      nodes_.offset = withNoise (nodes_.offset, 0.02, 122);
    Vectors normals = withRandomSigns (shape.normals, 121);
    for (std::size_t i = 0; i < normals.size (); i += 11)
      normals[i].setConstant (nan_float);
    normals_ = byNode (normals, *graph_);
  }

  /** Three values per node, initially poisoned. */
  std::vector<float>
  vectors () const
  {
    return std::vector<float> (3 * nodes_.size (), -77);
  }

  /** A value per node, above 0. */
  Numbers
  factorsOfNodes () const
  {
    Numbers factors;
    for (std::size_t i = 0; i < nodes_.size (); ++i)
      factors.push_back (0.2f + static_cast<float> (uniformNoise (124, i)));
    return factors;
  }

  std::vector<std::uint16_t>
  distanceWeights (const Kernels& kernels) const
  {
    std::vector<std::uint16_t> weights (graph_->blockBegin (graph_->blockCount ()), 77);
    forEachBlock (*graph_, Execution (1), [&] (const BlockRows& rows) {
      kernels.distance_weights ({nodeArrays (nodes_, normals_), weights.data ()}, rows);
    });
    return weights;
  }

  std::vector<float>
  filtered (const Kernels& kernels, pcl_normal_smoothing::NormalWeight weight, bool oriented, bool all_normals) const
  {
    const std::vector<std::uint16_t> distance_weights = distanceWeights (kernels);
    std::vector<float> filtered = vectors ();
    NormalFilterStep step {};
    step.nodes = nodeArrays (nodes_, normals_);
    step.distance_weights = distance_weights.data ();
    step.weight = weight;
    step.threshold = 0.65f;
    step.normal_factor = 5.6f;
    using pcl_normal_smoothing::MixedThreshold;
    step.mixed_threshold = oriented ? MixedThreshold::RMS : MixedThreshold::PRINTED;
    step.oriented = oriented;
    step.all_normals = all_normals;
    step.filtered = filtered.data ();
    forEachBlock (*graph_, Execution (1), [&] (const BlockRows& rows) { kernels.filter_normals (step, rows); });
    return filtered;
  }

  /** A step on the nodes, without displacement limit or factors. */
  PointUpdateStep
  updateStep (UpdateKind kind) const
  {
    PointUpdateStep step {};
    step.nodes = nodeArrays (nodes_, normals_);
    step.start = step.nodes.offset;
    step.kind = kind;
    step.reach_scale = 1;
    step.residual_factor = 100;
    step.normal_factor = 50;
    step.max_displacement = infinity;
    return step;
  }

  std::vector<float>
  moved (const Kernels& kernels, PointUpdateStep step) const
  {
    std::vector<float> moved = vectors ();
    step.moved = moved.data ();
    forEachBlock (*graph_, Execution (1), [&] (const BlockRows& rows) { kernels.update_points (step, rows); });
    return moved;
  }

  NeighborGraph::Ptr graph_;
  Positions nodes_;
  Vectors normals_;
};

/** Parameters for instantiating KernelsTest. */
inline auto
graphsForKernels ()
{
  return testing::Combine (testing::Values (3, 16, 333, 1000),
                           testing::Values (NeighborQuery {3, infinity}, NeighborQuery {12, infinity},
                                            NeighborQuery {0, 0.15f}));
}
} // namespace test_support
