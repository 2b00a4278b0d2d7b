// SPDX-License-Identifier: BSD-3-Clause
#include "tiles_fixture.h"

#include <filesystem>

namespace fs = std::filesystem;

namespace
{
class TilesTrouble : public Tiles
{
protected:
  void
  SetUp () override
  {
    saveCloud (wavyCloud (900), "cloud.pcd");
    succeed ("pcl_normal_smoothing cloud.pcd whole.pcd -preset fast");
  }

  void
  plan (const std::string& options = "-max_points 200 -preset fast") const
  {
    succeed ("pcl_normal_smoothing_tiles plan tiles.d cloud.pcd " + options);
  }

  /** Expects a message that contains all words, and no new file. */
  void
  expectRefused (const std::string& command, int status, const std::vector<std::string>& words) const
  {
    const std::set<std::string> before = files ();
    const Ending result = run ("pcl_normal_smoothing_tiles " + command);
    EXPECT_EQ (result.status, status) << command << "\n" << result.err;
    for (const std::string& word : words)
      EXPECT_NE (result.err.find (word), std::string::npos) << command << "\n" << result.err;
    EXPECT_EQ (files (), before) << command;
  }

  void
  expectMerged () const
  {
    succeed ("pcl_normal_smoothing_tiles merge tiles.d -output merged.pcd");
    EXPECT_TRUE (contentOf (path ("merged.pcd")) == contentOf (path ("whole.pcd")));
  }

  /** Flips a bit in the middle of a file. */
  void
  damage (const std::string& name) const
  {
    std::string content = contentOf (path (name));
    content[content.size () / 2] ^= 1;
    writeText (path (name), content);
  }

  /** Runs a tool with file sizes limited to some blocks of 512 bytes, as if the disk were full. */
  Ending
  runOnFullDisk (const std::string& command, int blocks) const
  {
    return RunningTool ({"/bin/sh", "-c",
                         "cd " + folder_ + "; ulimit -f " + std::to_string (blocks) +
                             "; exec " TOOLS_FOLDER "/pcl_normal_smoothing_tiles " + command},
                        folder_)
        .wait ();
  }
};
} // namespace

TEST_F (TilesTrouble, WrongUsage)
{
  expectRefused ("", 1, {"2 or more"});
  expectRefused ("walk tiles.d", 1, {"no step 'walk'"});
  expectRefused ("plan tiles.d", 1, {"no file is given"});
  expectRefused ("plan tiles.d cloud.pcd -k 8 -radius 2", 1, {"-k and -radius"});
  expectRefused ("plan tiles.d cloud.pcd -tile 3", 1, {"-tile is none of plan"});
  expectRefused ("plan tiles.d cloud.pcd -widen_neighborhoods 1", 1, {"give 0"});
  expectRefused ("run tiles.d -k 8", 1, {"-k is none of run"});
  expectRefused ("run tiles.d -tile 3x", 1, {"3x"});
  expectRefused ("run tiles.d -tile 5-3", 1, {"5-3"});
  plan ();
  expectRefused ("run tiles.d cloud.pcd", 1, {"plan only"});
  expectRefused ("run tiles.d -tile 99", 1, {"no tile 99"});
  expectRefused ("merge tiles.d", 1, {"-output_dir"});
  expectRefused ("merge tiles.d -output out.pcd -tile_dir out.d", 1, {"one of"});
  expectRefused ("merge tiles.d -output out.pcd -format compressed", 1, {"compressed"});
  expectRefused ("merge tiles.d -output out.xyz", 2, {"no complete result"});
}

TEST_F (TilesTrouble, OptionsThatDoNothingHereAreNamed)
{
  const Ending plan = succeed ("pcl_normal_smoothing_tiles plan tiles.d cloud.pcd -weights mixed -noise_sigma 1");
  EXPECT_NE (plan.err.find ("-noise_sigma: for the rounds"), std::string::npos) << plan.err;
}

TEST_F (TilesTrouble, SourcesThatDoNotGoTogether)
{
  savePcd (makeWave (), path ("wave.pcd"));
  expectRefused ("plan tiles.d cloud.pcd wave.pcd", 2,
                 {path ("wave.pcd"), path ("cloud.pcd"), "intensity", "histogram"});
  expectRefused ("plan tiles.d wave.pcd cloud.pcd", 2, {"intensity"});
  expectRefused ("plan tiles.d cloud.pcd cloud.pcd", 2, {"twice"});
  fs::copy_file (path ("cloud.pcd"), path ("caf\xe9.pcd"));
  expectRefused ("plan tiles.d caf\xe9.pcd", 2, {path ("caf\xe9.pcd"), "UTF-8", "rename it"});
  std::string named = contentOf (path ("wave.pcd"));
  named[named.find ("intensity")] = '\xe9';
  writeText (path ("named.pcd"), named);
  expectRefused ("plan tiles.d named.pcd", 2, {path ("named.pcd"), "UTF-8", "the field"});
  expectRefused ("plan tiles.d none.pcd", 2, {path ("none.pcd"), "No such file"});
  expectRefused ("plan tiles.d cloud.pcd -normals input", 3, {"normal_x"});
  succeed ("pcl_normal_smoothing cloud.pcd packed.pcd -format compressed");
  expectRefused ("plan tiles.d packed.pcd", 2, {"compressed", "pcl_convert_pcd_ascii_binary"});
  std::string cut = contentOf (path ("cloud.pcd"));
  cut.resize (cut.size () - 100);
  writeText (path ("cut.pcd"), cut);
  expectRefused ("plan tiles.d cloud.pcd cut.pcd", 2, {path ("cut.pcd"), "truncated"});
}

TEST_F (TilesTrouble, FoldersThatHoldOtherThings)
{
  fs::create_directory (path ("tiles.d"));
  writeText (path ("tiles.d/thesis.txt"), "precious");
  expectRefused ("plan tiles.d cloud.pcd", 2, {"other files", "thesis.txt"});
  EXPECT_EQ (contentOf (path ("tiles.d/thesis.txt")), "precious");
  expectRefused ("run tiles.d", 2, {"holds no plan"});
  expectRefused ("merge tiles.d -output out.pcd", 2, {"holds no plan"});
  fs::copy_file (path ("cloud.pcd"), path ("cloud.copy"));
  expectRefused ("plan cloud.copy cloud.pcd", 2, {path ("cloud.copy")});
  expectRefused ("plan cloud.pcd tiles.d", 1, {"the folder for the tiles comes first"});
  expectRefused ("plan other.d tiles.d", 2, {"is a folder"});
  fs::remove (path ("tiles.d/thesis.txt"));
  for (const char* left : {"plan.aBcDeF.json", "cells.aBcDeF.bin", "tile_000003.aBcDeF.result", "spill.aBcDeF"})
    writeText (path (std::string ("tiles.d/") + left), "by a process that was killed");
  plan ();
  EXPECT_EQ (filesIn ("tiles.d").size (), 7u);
  fs::create_directory (path ("scans.d"));
  for (const char* name : {"tile_000000.pcd", "plan.ply.pcd", "cells.pcd"}) {
    const std::string scan = std::string ("scans.d/") + name;
    fs::copy_file (path ("cloud.pcd"), path (scan));
    expectRefused ("plan scans.d " + scan, 2, {"other files", name});
    EXPECT_EQ (contentOf (path (scan)), contentOf (path ("cloud.pcd")));
    fs::remove (path (scan));
  }
}

TEST_F (TilesTrouble, TilesThatAreMissingOrDamagedAreListedAndRunAgain)
{
  plan ();
  expectRefused ("merge tiles.d -output merged.pcd", 2, {"5 of 5 tiles", ": 0 1 2 3 4"});
  succeed ("pcl_normal_smoothing_tiles run tiles.d -tile 1-3");
  EXPECT_EQ (succeed ("pcl_normal_smoothing_tiles list tiles.d").out, "0\n4\n");
  expectRefused ("merge tiles.d -output merged.pcd", 2, {"2 of 5 tiles", ": 0 4"});
  succeed ("pcl_normal_smoothing_tiles run tiles.d -tile 0/2");
  expectMerged ();
  damage ("tiles.d/tile_000002.result");
  expectRefused ("merge tiles.d -output again.pcd", 2, {"1 of 5 tiles", ": 2"});
  const Ending again = succeed ("pcl_normal_smoothing_tiles run tiles.d");
  EXPECT_NE (again.out.find ("tile 1: done before"), std::string::npos) << again.out;
  EXPECT_NE (again.out.find ("tile 2: 1"), std::string::npos) << again.out;
  EXPECT_NE (again.out.find ("tile 3: done before"), std::string::npos) << again.out;
  expectMerged ();
  fs::resize_file (path ("tiles.d/tile_000003.result"), 500);
  EXPECT_EQ (succeed ("pcl_normal_smoothing_tiles list tiles.d").out, "3\n");
}

TEST_F (TilesTrouble, DamagedPlans)
{
  plan ();
  damage ("tiles.d/tile_000001.points");
  const Ending damaged = run ("pcl_normal_smoothing_tiles run tiles.d -tile 1");
  EXPECT_EQ (damaged.status, 2) << damaged.err;
  EXPECT_NE (damaged.err.find ("tile_000001.points: is damaged"), std::string::npos) << damaged.err;
  EXPECT_EQ (filesIn ("tiles.d").count ("tile_000001.result"), 0u);
  fs::remove (path ("tiles.d/tile_000001.points"));
  EXPECT_EQ (run ("pcl_normal_smoothing_tiles run tiles.d -tile 1").status, 2);
  damage ("tiles.d/cells.bin");
  expectRefused ("run tiles.d", 2, {"damaged"});
  writeText (path ("tiles.d/plan.json"), "{}");
  expectRefused ("run tiles.d", 2, {"is no plan"});
}

TEST_F (TilesTrouble, PlansOfAnotherVersion)
{
  plan ();
  std::string text = contentOf (path ("tiles.d/plan.json"));
  const std::size_t at = text.find ("\"version\":");
  ASSERT_NE (at, std::string::npos) << text;
  writeText (path ("tiles.d/plan.json"), text.insert (text.find ('"', at + 10) + 1, "0."));
  expectRefused ("run tiles.d", 2, {"another version"});
  expectRefused ("merge tiles.d -output out.pcd", 2, {"another version"});
}

TEST_F (TilesTrouble, SourcesThatChange)
{
  plan ();
  succeed ("pcl_normal_smoothing_tiles run tiles.d");
  damage ("cloud.pcd");
  expectRefused ("merge tiles.d -output merged.pcd", 2, {path ("cloud.pcd"), "has changed"});
  damage ("cloud.pcd"); // restores the byte
  expectMerged ();
  fs::resize_file (path ("cloud.pcd"), 1000);
  expectRefused ("merge tiles.d -output again.pcd", 2, {path ("cloud.pcd"), "has changed"});
  fs::rename (path ("cloud.pcd"), path ("moved.pcd"));
  expectRefused ("merge tiles.d -output again.pcd", 2, {path ("cloud.pcd"), "No such file"});
}

TEST_F (TilesTrouble, APlanIsKeptForTheSameFilesAndOptionsOnly)
{
  plan ();
  succeed ("pcl_normal_smoothing_tiles run tiles.d");
  const auto results = [&] { return filesIn ("tiles.d").count ("tile_000000.result"); };
  const Ending again = succeed ("pcl_normal_smoothing_tiles plan tiles.d cloud.pcd -max_points 200 -preset fast");
  EXPECT_NE (again.out.find ("planned before"), std::string::npos) << again.out;
  EXPECT_EQ (results (), 1u);
  plan ("-max_points 200 -preset paper");
  EXPECT_EQ (results (), 0u);
  plan ();
  succeed ("pcl_normal_smoothing_tiles run tiles.d");
  saveCloud (wavyCloud (901), "cloud.pcd");
  plan ();
  EXPECT_EQ (results (), 0u);
  plan ("-preset fast"); // tile size by this machine's memory: elsewhere, the same call must keep the plan
  EXPECT_EQ (contentOf (path ("tiles.d/plan.json")).find ("max_points"), std::string::npos);
}

TEST_F (TilesTrouble, ResultsOfAnotherPlanDoNotCount)
{
  plan ("-max_points 200 -preset paper");
  succeed ("pcl_normal_smoothing_tiles run tiles.d -tile 0");
  fs::rename (path ("tiles.d/tile_000000.result"), path ("other.result"));
  plan ();
  fs::rename (path ("other.result"), path ("tiles.d/tile_000000.result"));
  succeed ("pcl_normal_smoothing_tiles run tiles.d");
  expectMerged ();
}

TEST_F (TilesTrouble, OutputsThatAreSources)
{
  plan ();
  succeed ("pcl_normal_smoothing_tiles run tiles.d");
  const std::string source = contentOf (path ("cloud.pcd"));
  expectRefused ("merge tiles.d -output cloud.pcd", 2, {"was planned"});
  expectRefused ("merge tiles.d -output_dir " + folder_, 2, {"was planned"});
  EXPECT_EQ (contentOf (path ("cloud.pcd")), source);
  fs::create_directory (path ("data.d"));
  fs::copy_file (path ("cloud.pcd"), path ("data.d/tile_000000.pcd"));
  succeed ("pcl_normal_smoothing_tiles plan other.d data.d/tile_000000.pcd -max_points 200 -preset fast");
  succeed ("pcl_normal_smoothing_tiles run other.d");
  expectRefused ("merge other.d -tile_dir data.d", 2, {"was planned"});
  EXPECT_EQ (contentOf (path ("data.d/tile_000000.pcd")), source);
}

TEST_F (TilesTrouble, FullDisk)
{
  const Ending planned = runOnFullDisk ("plan tiles.d cloud.pcd -max_points 200 -preset fast", 4);
  EXPECT_EQ (planned.status, 2) << planned.err;
  EXPECT_EQ (files ().count ("tiles.d"), 0u);
  plan ();
  const std::set<std::string> before = filesIn ("tiles.d");
  const Ending smoothed = runOnFullDisk ("run tiles.d", 4);
  EXPECT_EQ (smoothed.status, 2) << smoothed.err;
  EXPECT_EQ (filesIn ("tiles.d"), before);
  succeed ("pcl_normal_smoothing_tiles run tiles.d");
  for (const char* output : {"-output merged.pcd", "-output_dir merged.d", "-tile_dir merged.d"}) {
    const Ending merged = runOnFullDisk (std::string ("merge tiles.d ") + output, 4);
    EXPECT_EQ (merged.status, 2) << merged.err;
    EXPECT_EQ (files ().count ("merged.pcd"), 0u);
    EXPECT_TRUE (files ().count ("merged.d") == 0 || filesIn ("merged.d").empty ());
  }
  expectMerged ();
}

TEST_F (TilesTrouble, ManyRunsOfOneTileAtOnce)
{
  plan ("-max_points 2000 -preset fast");
  for (int round = 0; round < 3; ++round) {
    fs::remove (path ("tiles.d/tile_000000.result"));
    std::vector<RunningTool> runs;
    for (int i = 0; i < 6; ++i)
      runs.push_back (
          RunningTool ({TOOLS_FOLDER "/pcl_normal_smoothing_tiles", "run", path ("tiles.d"), "-tile", "0"}, folder_));
    for (RunningTool& started : runs)
      EXPECT_EQ (started.wait ().status, 0);
    EXPECT_EQ (filesIn ("tiles.d"),
               (std::set<std::string> {"cells.bin", "plan.json", "tile_000000.points", "tile_000000.result"}));
    expectMerged ();
  }
}
