// SPDX-License-Identifier: BSD-3-Clause
#include "files/field_values.h"
#include "tiles/region.h"
#include "tiles/tile_plan.h"
#include "tiles_fixture.h"

#include <cmath>
#include <map>

using namespace pcl_normal_smoothing;

TEST_F (Tiles, EveryPresetAndTileSize)
{
  saveCloud (wavyCloud (2000), "cloud.pcd");
  for (const char* options : {"", "-preset fast", "-preset paper"})
    for (const char* size : {"5000", "700", "150"})
      expectSame ("cloud.pcd", std::string ("-max_points ") + size, options);
}

/** However much memory there is: the points of a tile and those around it have numbers of 32 bits. */
TEST_F (Tiles, AreNoLargerThanTheirNumbers)
{
  constexpr std::uint64_t gigabyte = 1u << 30;
  const core::SmoothingOptions paper;
  EXPECT_GT (tools::pointsWithin (64 * gigabyte, paper, {7}), 100'000'000u);
  EXPECT_EQ (tools::pointsWithin (1'000'000 * gigabyte, paper, {7}), 1ull << 31);
}

TEST_F (Tiles, EveryWayOfTheChain)
{
  saveCloud (wavyCloud (1000), "cloud.pcd");
  for (const char* options :
       {"-normals hough -weights mixed -normal_iterations 3 -seed 7", "-preset paper -radius 0.9",
        "-preset paper -k 20 -max_radius 0.5", "-weights threshold -point_iterations 0 -save_normals 1",
        "-preset fast -radius 0.8 -save_normals 1", "-k 12", "-noise_sigma 0.05",
        "-point_spacing 0.25 -sheet_distance 0.3", "-preset fast -max_displacement 0.01 -point_iterations 1",
        "-normals pca -k 20", "-point_iterations 0 -save_normals 1"})
    expectSame ("cloud.pcd", "-max_points 200", options);
}

TEST_F (Tiles, ClustersOfUnevenDensityDuplicatesAndOutliers)
{
  saveCloud (clusters (), "cloud.pcd");
  for (const char* options : {"", "-preset fast", "-preset paper", "-preset paper -k 20 -max_radius 0.05"})
    for (const char* size : {"700", "90"})
      expectSame ("cloud.pcd", std::string ("-max_points ") + size, options);
}

TEST_F (Tiles, TiesAndPointsOnBorders)
{
  Cloud grid; // with bumps; otherwise the choice between equidistant neighbours would not matter
  for (int i = 0; i < 900; ++i)
    grid.push_back (Eigen::Vector3d (i % 30, i / 30, i % 3 == 0 && i / 30 % 2 == 0 ? 1 : 0) / 4);
  saveCloud (grid, "cloud.pcd");
  for (const char* size : {"225", "30"}) {
    expectSame ("cloud.pcd", std::string ("-max_points ") + size, "-preset paper -save_normals 1");
    expectSame ("cloud.pcd", std::string ("-max_points ") + size,
                "-noise_sigma 0.1 -save_normals 1 -widen_neighborhoods 0"); // or rounded coordinates would be detected
  }
}

TEST_F (Tiles, NoiseThatVariesIsTheSame)
{
  saveCloud (unevenlyNoisyWave (), "cloud.pcd");
  for (const char* options : {"", "-preset fast", "-noise_sigma 0.05 -noise_varies 1", "-noise_varies 0"})
    expectSame ("cloud.pcd", "-max_points 700", options);
}

TEST_F (Tiles, LayersAreNotBridgedAndThatIsSaid)
{
  Cloud layers;
  for (int i = 0; i < 2500; ++i)
    layers.push_back (Eigen::Vector3d (i % 50, i / 50, 5 * std::round (0.1 * (i % 50) + 0.02 * (i / 50))) / 16);
  saveCloud (layers, "cloud.pcd");
  expectSame ("cloud.pcd", "-max_points 700", "-widen_neighborhoods 0 -noise_sigma 0.1");
  const auto plan = succeed ("pcl_normal_smoothing_tiles plan tiles.d cloud.pcd -max_points 700");
  EXPECT_NE (plan.err.find ("might widen them"), std::string::npos) << plan.err;
  EXPECT_NE (plan.out.find ("-widen_neighborhoods 0"), std::string::npos) << plan.out;
}

TEST_F (Tiles, CloseSheetsAreSeparatedAlike)
{
  saveCloud (closeSheets (), "cloud.pcd");
  for (const char* options :
       {"", "-k 20 -save_normals 1", "-sheet_distance 0.04", "-preset fast", "-preset fast -k 24 -max_radius 0.25"})
    expectSame ("cloud.pcd", "-max_points 300", options);
  for (const std::string preset : {" -preset default", " -preset fast"}) {
    succeed ("pcl_normal_smoothing cloud.pcd separated.pcd" + preset);
    succeed ("pcl_normal_smoothing cloud.pcd mixed.pcd -sheet_distance inf" + preset);
    EXPECT_NE (contentOf (path ("separated.pcd")), contentOf (path ("mixed.pcd")))
        << "the test is of no use:" << preset;
  }
}

TEST_F (Tiles, CopiesInPartAndRowsOfFewPoints)
{
  Cloud cloud = wavyCloud (1500);
  for (std::size_t i = 0; i < 600; ++i) // copies: some once, some many times, some rounded differently
    cloud.insert (cloud.end (), i % 50 == 0 ? 40 : 1, cloud[i * 2] * (i % 3 == 0 ? 1 + 1e-7 : 1));
  saveCloud (cloud, "cloud.pcd");
  for (const char* options : {"", "-preset fast -save_normals 1", "-preset fast -k 16 -max_radius 0.28",
                              "-preset fast -noise_sigma 0.05 -max_radius 0.32"})
    for (const char* size : {"500", "100"})
      expectSame ("cloud.pcd", std::string ("-max_points ") + size, options);
  succeed ("pcl_normal_smoothing cloud.pcd normals.pcd -save_normals 1");
  expectSame ("normals.pcd", "-max_points 300", "-normals input -save_normals 1");
}

TEST_F (Tiles, RowsOfAFewPointsAreThoseOfAll)
{
  saveCloud (closeSheets (), "cloud.pcd");
  succeed ("pcl_normal_smoothing_tiles plan tiles.d cloud.pcd -max_points 1600");
  const tools::Plan plan = tools::loadPlan (path ("tiles.d"));
  const core::Execution execution (2);
  std::vector<tools::Region::Place> places;
  for (std::uint32_t cell = 0; cell < plan.cells.size (); ++cell)
    places.push_back ({cell, plan.cells[cell].box});

  const auto rowsOfEvery = [&] (std::uint64_t nth, const tools::Depth& depth) { // by the indices of points
    tools::Region region (plan, plan.query, execution);
    region.load (
        places, [nth] (std::uint32_t, std::uint64_t number) { return number % nth == 0; }, depth);
    const core::NeighborGraph& graph = *region.graph ();
    std::map<std::uint32_t, std::vector<std::uint32_t>> rows;
    for (const std::uint32_t node : region.wanted ())
      for (std::size_t j = 0; j < graph.row (node).size (); ++j)
        rows[graph.order ()[node]].push_back (graph.order ()[graph.row (node)[j]]);
    return rows;
  };
  auto separated = rowsOfEvery (1, {0, 3}), mixed = rowsOfEvery (1, {0, -1});
  ASSERT_EQ (separated.size (), 1600u);
  for (const auto& [number, row] : rowsOfEvery (800, {0, 3})) {
    EXPECT_EQ (row, separated[number]) << "point " << number;
    EXPECT_NE (row, mixed[number]) << "the test is of no use";
  }
  for (const auto& [number, row] : rowsOfEvery (800, {0, -1}))
    EXPECT_EQ (row, mixed[number]) << "point " << number;
}

TEST_F (Tiles, TilesOfOnePoint)
{
  savePcd (makeWave (), path ("wave.pcd"));
  expectSame ("wave.pcd", "-max_points 1", "-preset fast");
  const Ending plan = succeed ("pcl_normal_smoothing_tiles plan more.d wave.pcd -max_points 1 -preset fast");
  EXPECT_NE (plan.out.find ("298 points in 298 tiles of at most 1\n"), std::string::npos) << plan.out;
  const Ending tile = succeed ("pcl_normal_smoothing_tiles run more.d -tile 7");
  EXPECT_EQ (tile.out.find ("tile 7: 1 point, "), 0u) << tile.out;
}

TEST_F (Tiles, AllPointsInOnePlace)
{
  saveCloud (Cloud (500, {1, 2, 3}), "cloud.pcd");
  const Ending whole = run ("pcl_normal_smoothing cloud.pcd whole.pcd");
  succeed ("pcl_normal_smoothing_tiles plan tiles.d cloud.pcd -max_points 100");
  succeed ("pcl_normal_smoothing_tiles run tiles.d");
  const Ending merged = run ("pcl_normal_smoothing_tiles merge tiles.d -output merged.pcd");
  EXPECT_EQ (whole.status, 3);
  EXPECT_EQ (merged.status, 3);
  EXPECT_NE (merged.err.find ("no point has a normal"), std::string::npos) << merged.err;
  EXPECT_EQ (files ().count ("merged.pcd"), 0u);
}

TEST_F (Tiles, FewPoints)
{
  saveCloud (wavyCloud (10), "cloud.pcd"); // fewer than k
  expectSame ("cloud.pcd", "-max_points 3", "");
  expectSame ("cloud.pcd", "-max_points 3", "-preset paper");
  saveCloud (wavyCloud (2), "two.pcd");
  EXPECT_EQ (run ("pcl_normal_smoothing_tiles plan two.d two.pcd").status, 3);
  EXPECT_EQ (files ().count ("two.d"), 0u);
}

TEST_F (Tiles, EveryFormatAndField)
{
  const tools::CloudFile wave = makeWave (), far = makeWave (pcl::PCLPointField::FLOAT64, {500000, 5400000, 300});
  savePcd (wave, path ("binary.pcd"));
  savePcd (wave, path ("ascii.pcd"), false);
  savePcd (far, path ("far.pcd"));
  tools::saveCloud (wave, path ("binary.ply"), tools::FileFormat::BINARY);
  tools::saveCloud (wave, path ("ascii.ply"), tools::FileFormat::ASCII);
  for (const char* name : {"binary.pcd", "ascii.pcd", "far.pcd", "binary.ply", "ascii.ply"})
    for (const char* options : {"-preset fast", "-preset paper -save_normals 1"}) {
      expectSame (name, "-max_points 40", options);
      expectSame (name, "-max_points 40", options, ".ply");
      expectSame (name, "-max_points 40", options, ".pcd", "-format ascii");
    }
}

TEST_F (Tiles, NormalsOfTheInput)
{
  saveCloud (wavyCloud (800), "cloud.pcd");
  succeed ("pcl_hough_normal_estimation cloud.pcd normals.pcd");
  for (const char* options :
       {"-normals input", "-normals input -oriented 1", "-normals input -oriented 1 -save_normals 1",
        "-normals input -preset paper -save_normals 1"})
    expectSame ("normals.pcd", "-max_points 100", options);
}

TEST_F (Tiles, AnyUnit)
{
  for (const double unit : {1e-30, 1e-9, 1e12}) {
    Cloud cloud = wavyCloud (600);
    for (Eigen::Vector3d& point : cloud)
      point *= unit;
    saveCloud (cloud, "cloud.pcd");
    for (const char* options : {"", "-preset paper"})
      expectSame ("cloud.pcd", "-max_points 100", options);
  }
}

TEST_F (Tiles, ManyFilesAreOneCloud)
{
  const Cloud cloud = wavyCloud (1200);
  const auto part = [&] (int begin, int end) { return Cloud (cloud.begin () + begin, cloud.begin () + end); };
  saveCloud (cloud, "cloud.pcd");
  saveCloud (part (0, 500), "a.pcd");
  saveCloud ({}, "b.pcd");
  saveCloud (part (500, 900), "c.pcd");
  saveCloud (part (900, 1200), "d.ply");
  succeed ("pcl_normal_smoothing cloud.pcd whole.pcd");
  succeed ("pcl_normal_smoothing_tiles plan tiles.d a.pcd b.pcd c.pcd d.ply -max_points 150");
  succeed ("pcl_normal_smoothing_tiles run tiles.d");
  succeed ("pcl_normal_smoothing_tiles merge tiles.d -output merged.pcd");
  EXPECT_EQ (contentOf (path ("merged.pcd")), contentOf (path ("whole.pcd")));
  succeed ("pcl_normal_smoothing_tiles merge tiles.d -output_dir merged.d");
  std::string parts, whole;
  for (const char* name : {"merged.d/a.pcd", "merged.d/b.pcd", "merged.d/c.pcd", "merged.d/d.ply"})
    for (const char* field : {"x", "y", "z"})
      whole += field + bytesOf (tools::loadCloud (path (name)), field);
  for (const auto& [begin, end] :
       {std::pair (0, 500), std::pair (500, 500), std::pair (500, 900), std::pair (900, 1200)})
    for (const char* field : {"x", "y", "z"})
      parts += field + bytesOf (tools::loadCloud (path ("whole.pcd")), field)
                           .substr (static_cast<std::size_t> (begin) * 4, static_cast<std::size_t> (end - begin) * 4);
  EXPECT_EQ (parts, whole);
}

TEST_F (Tiles, DuplicatesAcrossFiles)
{
  Cloud cloud = wavyCloud (400);
  saveCloud (cloud, "a.pcd");
  saveCloud (cloud, "b.pcd");
  cloud.insert (cloud.end (), cloud.begin (), cloud.begin () + 400);
  saveCloud (cloud, "cloud.pcd");
  succeed ("pcl_normal_smoothing cloud.pcd whole.pcd");
  succeed ("pcl_normal_smoothing_tiles plan tiles.d a.pcd b.pcd -max_points 70");
  succeed ("pcl_normal_smoothing_tiles run tiles.d");
  succeed ("pcl_normal_smoothing_tiles merge tiles.d -output merged.pcd");
  EXPECT_EQ (contentOf (path ("merged.pcd")), contentOf (path ("whole.pcd")));
}

TEST_F (Tiles, FilesOfTiles)
{
  savePcd (makeWave (), path ("wave.pcd"));
  succeed ("pcl_normal_smoothing wave.pcd whole.pcd");
  succeed ("pcl_normal_smoothing_tiles plan tiles.d wave.pcd -max_points 100");
  succeed ("pcl_normal_smoothing_tiles run tiles.d");
  succeed ("pcl_normal_smoothing_tiles merge tiles.d -tile_dir out.d");
  std::multiset<std::string> points, expected;
  const tools::CloudFile whole = readPcdFile (path ("whole.pcd"));
  for (std::size_t i = 0; i < whole.size (); ++i)
    if (positionOf (whole, i).allFinite ())
      expected.insert (bytesOf (whole, "x").substr (4 * i, 4) + bytesOf (whole, "rgba").substr (4 * i, 4) +
                       bytesOf (whole, "stamp").substr (8 * i, 8));
  for (const char* name :
       {"out.d/tile_000000.pcd", "out.d/tile_000001.pcd", "out.d/tile_000002.pcd", "out.d/tile_000003.pcd"}) {
    const tools::CloudFile tile = readPcdFile (path (name));
    EXPECT_LE (tile.size (), 100u);
    for (std::size_t i = 0; i < tile.size (); ++i)
      points.insert (bytesOf (tile, "x").substr (4 * i, 4) + bytesOf (tile, "rgba").substr (4 * i, 4) +
                     bytesOf (tile, "stamp").substr (8 * i, 8));
  }
  EXPECT_EQ (points, expected);
}
