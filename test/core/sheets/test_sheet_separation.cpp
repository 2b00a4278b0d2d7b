// SPDX-License-Identifier: BSD-3-Clause
#include "graph_rows.h"
#include "shapes.h"

#include <core/search/node_blocks.h>
#include <core/sheets/sheet_criterion.h>
#include <core/sheets/sheet_separation.h>
#include <pcl_normal_smoothing/core/rounds/robust_smoothing.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace
{
using namespace pcl_normal_smoothing::core;
using namespace test_support;

constexpr float spacing = 0.02f;
constexpr float noise = 0.2f * spacing;

struct Separated
{
  NeighborGraph::ConstPtr before, after;
  Positions nodes;
};

Separated
separated (const Vectors& points, float distance, unsigned threads = 2)
{
  const Execution execution (threads);
  Separated result;
  result.before = NeighborGraph::build (asPositions (points), {32}, execution);
  result.nodes = gather (asPositions (points), result.before->order ());
  result.after = separateSheets (result.before, result.nodes, {distance}, execution);
  return result;
}

/** The share of neighbours that lie on the other sheet; the cloud holds first one sheet, then the other. */
double
shareOfOthers (const NeighborGraph& graph)
{
  const std::size_t half = graph.cloudSize () / 2;
  double others = 0, all = 0;
  for (std::size_t node = 0; node < graph.size (); ++node)
    for (const std::uint32_t neighbor : rowInCloud (graph, node)) {
      others += (neighbor < half) != (graph.order ()[node] < half);
      ++all;
    }
  return others / all;
}

TEST (SheetSeparationTest, RowsKeepToTheirSheet)
{
  // Those that remain are along the outline, where a plane across both sheets fits as well, and in rows with only one
  // or two of them.
  const std::pair<float, double> shares_left[] = {{1.5f, 0.35}, {2.0f, 0.2}, {3.0f, 0.2}};
  for (const auto& [gap, share_left] : shares_left) {
    const Separated sheets =
        separated (withNormalNoise (parallelSheets (50, spacing, gap * spacing), noise, 3), 4 * noise);
    const double before = shareOfOthers (*sheets.before), after = shareOfOthers (*sheets.after);
    EXPECT_GT (before, 0.05) << gap << " spacings apart";
    EXPECT_LT (after, share_left * before) << gap << " spacings apart: " << before << " -> " << after;
  }
}

TEST (SheetSeparationTest, ChangedRowsAreFullAndInOrder)
{
  const Separated sheets = separated (withNormalNoise (parallelSheets (30, spacing, 2 * spacing), noise, 4), 4 * noise);
  for (std::uint32_t node = 0; node < sheets.after->size (); ++node) {
    const Row row = sheets.after->row (node);
    ASSERT_EQ (row.size (), 32u) << node;
    ASSERT_EQ (row[0], node);
    for (std::size_t j = 1; j + 1 < row.size (); ++j)
      ASSERT_LE (squaredLength (sheets.nodes.difference (node, row[j])),
                 squaredLength (sheets.nodes.difference (node, row[j + 1])));
  }
}

TEST (SheetSeparationTest, NeighboursPastThe32ndDoNotMatter)
{
  const Positions cloud = asPositions (withNormalNoise (parallelSheets (40, spacing, 1.2f * spacing), noise, 8));
  const Execution execution (2);
  const auto rows_of = [&] (std::uint32_t k, bool separate) {
    const NeighborGraph::ConstPtr graph = NeighborGraph::build (cloud, {k}, execution);
    const Positions nodes = gather (cloud, graph->order ());
    return rowsByPoint (separate ? *separateSheets (graph, nodes, {4 * noise}, execution) : *graph);
  };
  const auto searched = rows_of (32, false), expected = rows_of (32, true), of_long = rows_of (150, true);
  std::size_t changed = 0;
  for (std::size_t i = 0; i < cloud.size (); ++i) {
    const bool same = expected[i] == searched[i];
    changed += !same;
    ASSERT_EQ (of_long[i].size (), same ? 150u : expected[i].size ()) << i;
    EXPECT_TRUE (std::equal (expected[i].begin (), expected[i].end (), of_long[i].begin ())) << i;
  }
  EXPECT_GT (changed, cloud.size () / 2);
}

TEST (SheetSeparationTest, OneSheetStaysAsItIs)
{
  const Shape shapes[] = {planeGrid (60, spacing), sphere (30000, 1), cube (50, 1), torus (20000, 1, 0.4)};
  for (const Shape& shape : shapes) {
    const Separated sheet = separated (withNormalNoise (shape, noise, 5), 4 * noise);
    std::size_t changed = 0;
    for (std::size_t node = 0; node < sheet.before->size (); ++node)
      changed += rowInCloud (*sheet.before, node) != rowInCloud (*sheet.after, node);
    EXPECT_LT (changed, sheet.before->size () / 100);
  }
}

TEST (SheetSeparationTest, AnInfiniteDistanceChangesNothing)
{
  const Separated sheets =
      separated (parallelSheets (20, spacing, 2 * spacing).points, std::numeric_limits<float>::infinity ());
  EXPECT_EQ (sheets.before, sheets.after);
}

TEST (SheetSeparationTest, OrientedNormalsSeparateSheetsAtOneSpacing)
{
  const Shape sheets = parallelSheets (40, spacing, spacing);
  const Execution execution (2);
  const Positions cloud = asPositions (withNormalNoise (sheets, noise, 6));
  const NeighborGraph::ConstPtr graph = NeighborGraph::build (cloud, {32}, execution);
  const Vectors normals = byNode (sheets.normals, *graph);
  const Positions nodes = gather (cloud, graph->order ());
  EXPECT_EQ (shareOfOthers (*separateSheets (graph, nodes, {1, &normals}, execution)), 0);
}

/** One rule, written for a pair of points and for many rows at once: sheets are found by the one and parted by the
  * other. */
TEST (SheetCriterionTest, CountsInRowsWhatItFindsInPairs)
{
  const Shape shape = parallelSheets (40, spacing, 1.5f * spacing);
  const Execution execution (2);
  const Positions cloud = asPositions (withNormalNoise (shape, noise, 9));
  const NeighborGraph::ConstPtr graph = NeighborGraph::build (cloud, {32}, execution);
  const Positions nodes = gather (cloud, graph->order ());
  Vectors normals = startNormals (*graph, nodes, execution);
  for (const bool oriented : {false, true}) {
    const SheetCriterion criterion (nodes, normals, 4 * noise, oriented);
    for (const SheetEvidence& evidence : {evidence_to_change, evidence_to_drop}) {
      Numbers others (nodes.size ());
      const OtherSheetCount of_rows = criterion.ofRows (evidence, others);
      forEachBlockOf (*graph, nullptr, sheet_row_length, execution,
                      [&] (const BlockRows& rows) { kernels ().count_others (of_rows, rows); });
      std::size_t differing = 0, beside = 0;
      for (std::uint32_t node = 0; node < graph->size (); ++node) {
        const Row row = graph->row (node);
        float expected = 0;
        for (std::size_t j = 1; j < row.size (); ++j)
          expected += criterion.isOther (node, row[j], evidence) ? 1.f : 0.f;
        differing += others[node] != expected;
        beside += expected > 0;
      }
      EXPECT_GT (beside, nodes.size () / 2);
      EXPECT_LE (differing, nodes.size () / 1000); // where rounding decides
    }
  }
}

TEST (SheetSeparationTest, ThreadsDoNotMatter)
{
  const Vectors points = withNormalNoise (parallelSheets (40, spacing, 1.5f * spacing), noise, 7);
  const auto expected = rowsByPoint (*separated (points, 4 * noise, 1).after);
  EXPECT_EQ (rowsByPoint (*separated (points, 4 * noise, 4).after), expected);
}
} // namespace
