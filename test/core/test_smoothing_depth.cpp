// SPDX-License-Identifier: BSD-3-Clause
#include "graph_rows.h"
#include "shapes.h"

#include <core/smoothing_preparation.h>

#include <gtest/gtest.h>

#include <string>

namespace
{
using namespace pcl_normal_smoothing;
using namespace pcl_normal_smoothing::core;
using namespace test_support;

constexpr int side = 40;
constexpr float spacing = 0.02f;

/** A sheet with noise and its neighbourhoods. */
struct Sheet
{
  Positions nodes;
  NeighborGraph::ConstPtr graph;

  Sheet (std::uint32_t k, float noise)
  {
    Vectors points = planeGrid (side, spacing).points;
    for (std::size_t i = 0; i < points.size (); ++i)
      points[i] += Eigen::Vector3f (0.3f, 0.3f, noise) * spacing * static_cast<float> (gaussianNoise (5, i));
    graph = NeighborGraph::build (asPositions (points), {k}, Execution (2));
    nodes = gather (asPositions (points), graph->order ());
  }

  /** Number of hops along the rows from \a node to every other node. */
  std::vector<int>
  hopsFrom (std::uint32_t node) const
  {
    std::vector<int> hops (graph->size (), 1 << 20);
    hops[node] = 0;
    std::vector<std::uint32_t> seen {node};
    for (std::size_t i = 0; i < seen.size (); ++i) {
      const Row row = graph->row (seen[i]);
      for (std::size_t j = 0; j < row.size (); ++j)
        if (hops[row[j]] == 1 << 20) {
          hops[row[j]] = hops[seen[i]] + 1;
          seen.push_back (row[j]);
        }
    }
    return hops;
  }

  /** The nodes, with those at least \a least hops away moved. */
  Positions
  movedFrom (const std::vector<int>& hops, int least) const
  {
    Positions moved = nodes;
    for (std::size_t i = 0; i < hops.size (); ++i)
      if (hops[i] >= least)
        moved.offset[i] += Eigen::Vector3f (0.1f, -0.2f, 0.9f) * spacing * static_cast<float> (uniformNoise (6, i));
    return moved;
  }

  /** The graph, with other rows for nodes at least \a least hops away. */
  NeighborGraph::ConstPtr
  graphFrom (const std::vector<int>& hops, int least) const
  {
    std::vector<std::uint32_t> changed, rows;
    for (std::uint32_t node = 0; node < graph->size (); ++node)
      if (hops[node] >= least) {
        changed.push_back (node);
        for (std::uint32_t j = 0; j < 4; ++j)
          rows.push_back (j == 0 ? node : (node + 100 * j) % static_cast<std::uint32_t> (graph->size ()));
      }
    return graph->withRows (changed, rows, 4);
  }
};

struct Result
{
  Eigen::Vector3f offset, normal;

  bool
  operator== (const Result& other) const
  {
    return offset == other.offset && normal == other.normal;
  }
};

Result
smoothedNode (const NeighborGraph::ConstPtr& graph,
              const Positions& nodes,
              const SmoothingOptions& options,
              std::uint32_t node)
{
  const Vectors normals (graph->size (), Eigen::Vector3f (0.6f, 0, 0.8f)); // for NormalSource::INPUT
  MovingSurface surface (nodes, normals);
  smooth (graph, options, {}, Execution (2), surface);
  return {surface.positions.offset[node], surface.normals[node]};
}

/** Expects that nothing beyond the depth has an influence, and that something at the depth has one on some nodes.
  * \param[in] unseen hops without visible influence: while steps are taken whole, the averages of the first round
  * decide nothing */
void
expectDepth (const SmoothingOptions& options, std::uint32_t k, int depth, int unseen = 0)
{
  SCOPED_TRACE ("depth " + std::to_string (depth));
  ASSERT_EQ (smoothingDepth (options), depth);
  // More noise than the options state, so that steps are not taken whole.
  const Sheet sheet (k, options.in_rounds ? 2 * options.rounds.noise.sigma / spacing : 0.2f);
  int by_points = 0, by_rows = 0;
  for (std::uint32_t node = 0; node < sheet.graph->size (); node += 101) {
    const std::vector<int> hops = sheet.hopsFrom (node);
    const Result expected = smoothedNode (sheet.graph, sheet.nodes, options, node);
    const auto beyond = sheet.graphFrom (hops, depth);
    EXPECT_EQ (smoothedNode (beyond, sheet.movedFrom (hops, depth + 1), options, node), expected);
    by_points += !(smoothedNode (sheet.graph, sheet.movedFrom (hops, depth - unseen), options, node) == expected);
    by_rows += !(smoothedNode (sheet.graphFrom (hops, depth - unseen - 1), sheet.nodes, options, node) == expected);
  }
  EXPECT_GT (by_points, 0);
  EXPECT_GT (by_rows, 0);
}

SmoothingOptions
chain (NormalSource source, int normal_iterations, int point_iterations)
{
  SmoothingOptions options;
  options.normals = source;
  options.filter.iterations = normal_iterations;
  options.update.iterations = point_iterations;
  return options;
}

SmoothingOptions
rounds (int count, bool fast, float noise)
{
  SmoothingOptions options;
  options.in_rounds = true;
  options.rounds.count = count;
  options.rounds.fast = fast;
  options.rounds.noise = {noise * spacing, spacing};
  return options;
}

TEST (SmoothingDepthTest, Chain)
{
  expectDepth (chain (NormalSource::PCA, 1, 1), 8, 3);
  expectDepth (chain (NormalSource::WPCA, 2, 3), 8, 6);
  expectDepth (chain (NormalSource::HOUGH, 0, 1), 8, 2);
  expectDepth (chain (NormalSource::INPUT, 0, 2), 8, 2);
  expectDepth (chain (NormalSource::WPCA, 2, 0), 8, 3);
}

TEST (SmoothingDepthTest, Rounds)
{
  // A hop each for the fit, the update, each of the three or four averages of a round, and for the filter (from the
  // second round on; with fast, where the noise is large). The first fit uses the initial normals, and, except with
  // fast, how far apart its neighbours' neighbours are. Keeping points apart at the end adds one hop. In far rounds,
  // whatever uses neighbours uses those of the neighbours.
  expectDepth (rounds (1, false, .2f), 12, 2 + 1 + 4 + 1, 6);
  expectDepth (rounds (1, false, .4f), 12, 2 + 1 + 4 + 1, 6);
  expectDepth (rounds (2, false, .2f), 12, (2 + 1 + 4) + (1 + 1 + 1 + 4) + 1, 6);
  expectDepth (rounds (1, false, .6f), 20, 2 + 1 + 4 + 1, 6);
  expectDepth (rounds (1, true, .2f), 12, 1 + 1 + 3 + 1, 4);
  expectDepth (rounds (2, true, .2f), 12, 2 * (1 + 1 + 3) + 1, 4);
  expectDepth (rounds (2, true, .4f), 12, 2 * (1 + 1 + 1 + 3) + 1, 4);
  expectDepth (rounds (3, true, .2f), 12, 2 * (1 + 1 + 3) + (2 + 2 + 3) + 1, 8);
  expectDepth (rounds (3, true, .4f), 12, 2 * (1 + 1 + 1 + 3) + (2 + 2 + 2 + 3) + 1, 9);
  SmoothingOptions given = rounds (2, true, .2f);
  given.rounds.oriented = true;
  expectDepth (given, 12, 1 + 2 * (1 + 1 + 3) + 1, 4);
  given.normals = NormalSource::INPUT;
  expectDepth (given, 12, 2 * (1 + 1 + 3) + 1, 4);
  expectDepth (rounds (0, true, .2f), 12, 1);
}

TEST (SmoothingDepthTest, OfThePresets)
{
  SmoothingOptions standard = rounds (6, false, .2f), fast = rounds (3, true, .2f);
  EXPECT_EQ (smoothingDepth (standard), 46);
  EXPECT_EQ (smoothingDepth (fast), 18);
  EXPECT_EQ (smoothingDepth (chain (NormalSource::PCA, 5, 7)), 13);
}

/** Two close sheets. */
Sheet
twoSheets ()
{
  Sheet sheet (12, 0.2f);
  Vectors points = sheet.nodes.base;
  for (std::size_t i = 0; i < points.size (); ++i)
    points[i].z () =
        static_cast<float> (i % 2) * 1.5f * spacing + 0.2f * spacing * static_cast<float> (gaussianNoise (7, i));
  sheet.graph = NeighborGraph::build (asPositions (points), {12}, Execution (2));
  sheet.nodes = gather (asPositions (points), sheet.graph->order ());
  return sheet;
}

TEST (SmoothingDepthTest, OfTheSeparationOfSheets)
{
  const Sheet sheet = twoSheets ();
  const Vectors oriented (sheet.graph->size (), Eigen::Vector3f (0, 0, 1));
  EXPECT_EQ (separationDepth ({}), -1);
  EXPECT_EQ (separationDepth ({spacing, &oriented}), 1);
  const SheetSeparationOptions options {0.8f * spacing};
  const int depth = separationDepth (options);
  ASSERT_EQ (depth, 5);
  const Execution execution (2);
  const auto rows = rowsByPoint (*separateSheets (sheet.graph, sheet.nodes, options, execution));
  int changed = 0, within_it = 0;
  for (std::uint32_t node = 0; node < sheet.graph->size (); node += 5) {
    const std::uint32_t point = sheet.graph->order ()[node];
    const std::vector<int> hops = sheet.hopsFrom (node);
    changed += rows[point] != rowInCloud (*sheet.graph, node);
    // The row of a node holds points up to one hop farther away.
    const auto beyond =
        separateSheets (sheet.graphFrom (hops, depth + 1), sheet.movedFrom (hops, depth + 2), options, execution);
    EXPECT_EQ (rowInCloud (*beyond, node), rows[point]);
    // An influence of the very last hop is too rare to test: a start normal would have to decide a vote that decides
    // whether nodes vote again.
    const auto within =
        separateSheets (sheet.graphFrom (hops, depth - 1), sheet.movedFrom (hops, depth), options, execution);
    within_it += rowInCloud (*within, node) != rows[point];
  }
  EXPECT_GT (changed, 5);
  EXPECT_GT (within_it, 0);
}
} // namespace
