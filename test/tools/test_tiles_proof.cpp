// SPDX-License-Identifier: BSD-3-Clause
#include "tiles/region.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

using namespace pcl_normal_smoothing;
using namespace pcl_normal_smoothing::tools;

namespace
{
/** Points in the cells of a cube, as in a plan, but without files. */
struct Cubes
{
  Plan plan;
  core::Positions cloud;
  std::vector<std::uint32_t> cell_of;

  Cubes (std::size_t points, bool ties)
  {
    std::mt19937 random (23);
    std::uniform_real_distribution<float> place (0, 1);
    constexpr int side = 5;
    plan.cells.resize (side * side * side);
    for (std::size_t i = 0; i < points; ++i) {
      Eigen::Vector3f point (place (random), place (random), place (random));
      point.x () *= point.x (); // uneven
      if (ties)
        point = (point * 12).array ().round () / 12;
      const Eigen::Array3i at = (point * (side - 1)).array ().cast<int> ();
      const int cell = (at.x () * side + at.y ()) * side + at.z ();
      cloud.base.push_back (point);
      cell_of.push_back (static_cast<std::uint32_t> (cell));
      plan.cells[static_cast<std::size_t> (cell)].box.extend (point.cast<double> ());
    }
    cloud.offset.assign (points, Eigen::Vector3f::Zero ());
  }
};

/** The rows of all points, in indices of the cloud. */
std::vector<std::vector<std::uint32_t>>
rowsOf (const core::NeighborGraph& graph, const std::vector<std::uint32_t>& numbers, std::size_t size)
{
  std::vector<std::vector<std::uint32_t>> rows (size);
  for (std::size_t node = 0; node < graph.size (); ++node) {
    const core::Row row = graph.row (node);
    for (std::size_t j = 0; j < row.size (); ++j)
      rows[numbers[graph.order ()[node]]].push_back (numbers[graph.order ()[row[j]]]);
  }
  return rows;
}

struct Part
{
  std::size_t loaded = 0, wrong = 0, doubted = 0, wrong_without_doubt = 0;
};

/** Searches only among the points of some cells. */
Part
searchPart (const Cubes& cubes, const core::NeighborQuery& query, const std::vector<std::uint32_t>& cells)
{
  CellIndex index (cubes.plan.cells);
  for (const std::uint32_t cell : cells)
    index.setLoaded (cell);
  std::vector<std::uint32_t> all (cubes.cell_of.size ()), numbers, cell_of, wanted;
  for (std::uint32_t i = 0; i < all.size (); ++i) {
    all[i] = i;
    if (!index.isLoaded (cubes.cell_of[i]))
      continue;
    numbers.push_back (i);
    cell_of.push_back (cubes.cell_of[i]);
    wanted.push_back (static_cast<std::uint32_t> (wanted.size ()));
  }
  const core::Execution execution (2);
  const core::Positions part = core::gather (cubes.cloud, core::Elements (numbers.begin (), numbers.end ()));
  const auto graph = core::NeighborGraph::build (part, query, execution);
  const core::Positions nodes = core::gather (part, graph->order ());
  const auto expected = rowsOf (*core::NeighborGraph::build (cubes.cloud, query, execution), all, all.size ());
  const auto found = rowsOf (*graph, numbers, all.size ());
  std::set<std::uint32_t> doubted;
  for (const Doubt& doubt :
       findDoubts ({cubes.plan, query, *graph, *graph, nodes, cell_of, index}, wanted, Depth {0, -1}, execution))
    doubted.insert (numbers[graph->order ()[doubt.node]]);
  Part result;
  result.loaded = numbers.size ();
  result.doubted = doubted.size ();
  for (const std::uint32_t i : numbers) {
    result.wrong += found[i] != expected[i];
    result.wrong_without_doubt += found[i] != expected[i] && doubted.count (i) == 0;
  }
  return result;
}

const std::vector<core::NeighborQuery> queries {{8},        {40},           {0, 0.15f},
                                                {12, 0.2f}, {0, 1.0f / 12}, {0, 1.0f / 12 + 1e-6f},
                                                {6}};
} // namespace

TEST (TilesProof, NoWrongRowIsTakenForCertain)
{
  std::size_t wrong = 0, certain = 0;
  for (const bool ties : {false, true}) {
    const Cubes cubes (2500, ties);
    for (const core::NeighborQuery& query : queries)
      for (const std::uint32_t first : {0u, 40u, 62u}) {
        std::vector<std::uint32_t> cells;
        for (std::uint32_t cell = first; cell < first + 45; ++cell)
          cells.push_back (cell);
        const Part part = searchPart (cubes, query, cells);
        EXPECT_EQ (part.wrong_without_doubt, 0u) << "k " << query.k << " radius " << query.radius << " ties " << ties;
        wrong += part.wrong;
        certain += part.loaded - part.doubted;
      }
  }
  EXPECT_GT (wrong, 1000u) << "the test is of no use";
  EXPECT_GT (certain, 5000u);
}

TEST (TilesProof, NothingIsDoubtedWhereAllIsLoaded)
{
  const Cubes cubes (300, true);
  std::vector<std::uint32_t> cells;
  for (std::uint32_t cell = 0; cell < cubes.plan.cells.size (); ++cell)
    cells.push_back (cell);
  EXPECT_EQ (searchPart (cubes, {400}, cells).doubted, 0u);
}

TEST (TilesProof, CellsThatAreNotLoaded)
{
  const Cubes cubes (2000, false);
  CellIndex index (cubes.plan.cells);
  for (std::uint32_t cell = 0; cell < cubes.plan.cells.size (); cell += 3)
    index.setLoaded (cell);
  const Eigen::Vector3d place (0.3, 0.6, 0.1);
  for (const double distance : {0.0, 0.05, 0.2, 0.7}) {
    std::set<std::uint32_t> expected, found;
    for (std::uint32_t cell = 0; cell < cubes.plan.cells.size (); ++cell)
      if (cell % 3 != 0 && !cubes.plan.cells[cell].box.isEmpty () &&
          cubes.plan.cells[cell].box.exteriorDistance (place) <= distance)
        expected.insert (cell);
    index.forEachNear (Eigen::AlignedBox3d (place), distance,
                       [&] (std::uint32_t cell, double) { found.insert (cell); });
    EXPECT_EQ (found, expected);
    EXPECT_EQ (index.isNear (place, distance), !expected.empty ());
  }
}
