// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation_meshes.h"
#include "tool_runner.h"

#include <nlohmann/json.hpp>

#include <csignal>
#include <filesystem>
#include <map>
#include <thread>

using namespace pcl_normal_smoothing;

namespace
{
class StudyTool : public ToolTest
{
protected:
  StudyTool () : ToolTest (STUDY_FOLDER) {}

  void
  SetUp () override
  {
    tools::Mesh mesh = squareMesh (16);
    for (Eigen::Vector3d& vertex : mesh.vertices) // makes it a roof
      vertex.z () = 0.5 - std::abs (vertex.x () - 0.5);
    writeText (path ("roof.off"), asOff (mesh));
  }

  nlohmann::json
  rows (const std::string& folder = "study") const
  {
    return nlohmann::json::parse (contentOf (path (folder) + "/rows.json"));
  }

  Ending
  study (const std::string& rest) const
  {
    return run ("pcl_smoothing_study " + path ("study") + " " + rest);
  }

  /** The rows without the values that depend on the clock. */
  static nlohmann::json
  withoutSeconds (nlohmann::json all)
  {
    for (nlohmann::json& row : all)
      row.erase ("seconds");
    return all;
  }
};
} // namespace

TEST_F (StudyTool, OneMesh)
{
  const Ending ending = study ("roof.off -models none -peers 0 -sigma 0.1,0.3 -noise GR -seeds 2");
  ASSERT_EQ (ending.status, 0) << ending.err;
  EXPECT_NE (ending.out.find ("1096 rows, 0 failed, 0 absent"), std::string::npos) << ending.out;
  const nlohmann::json all = rows ();
  ASSERT_EQ (all.size (), 2u * (2 * 4 + 540)); // the sweep runs for the first seed only
  std::size_t clouds = 0;
  for (const nlohmann::json& row : all) {
    EXPECT_EQ (row.at ("status"), "ok");
    EXPECT_EQ (row.at ("model"), "roof");
    EXPECT_EQ (row.at ("points"), 256);
    for (const char* measure : {"E_A", "E_k7", "p2s_mean", "p2s_ratio", "p2p_ratio", "normal_angle", "edge_error",
                                "edge_fraction", "spacing_p01"})
      EXPECT_TRUE (row.at (measure).is_number ()) << measure << row;
    EXPECT_TRUE (row.at ("exact_mean").is_null ());
    if (const auto cloud = row.at ("cloud").get<std::string> (); !cloud.empty ()) {
      EXPECT_TRUE (std::filesystem::exists (path ("study/") + cloud)) << cloud;
      ++clouds;
    }
  }
  EXPECT_EQ (clouds, 2u * (4 + 2)); // the noisy cloud, three presets, best and worst of the sweep
  EXPECT_NEAR (all[0].at ("p2s_ratio").get<double> (), 1, 1e-12);
  EXPECT_NEAR (all[0].at ("p2p_mean").get<double> (), 0.1 * 0.798, 0.02);
  EXPECT_TRUE (std::filesystem::exists (path ("study/models/roof.ply")));
}

TEST_F (StudyTool, GoesOnWhereItWasKilled)
{
  const std::string command = " " + path ("roof.off") + " -models none -peers 0 -noise GN -seeds 1";
  ASSERT_EQ (run ("pcl_smoothing_study " + path ("whole") + command).status, 0);
  // Kill it again and again while it works, until it ends by itself.
  int kills = 0;
  for (int milliseconds = 60;; milliseconds *= 2) {
    RunningTool tool ({STUDY_FOLDER "/pcl_smoothing_study", path ("study"), path ("roof.off"), "-models", "none",
                       "-peers", "0", "-noise", "GN", "-seeds", "1"},
                      folder_);
    std::this_thread::sleep_for (std::chrono::milliseconds (milliseconds));
    tool.send (kills % 2 == 0 ? SIGKILL : SIGINT);
    const Ending ending = tool.wait ();
    if (ending.status == 0)
      break;
    ++kills;
    EXPECT_TRUE (ending.status == 128 + SIGKILL || ending.status == 128 + SIGINT) << ending.err;
    const bool begun = std::filesystem::exists (path ("study/rows.json"));
    EXPECT_LE (begun ? rows ().size () : 0, 544u); // and the file is complete
  }
  EXPECT_GT (kills, 0);
  EXPECT_EQ (withoutSeconds (rows ()), withoutSeconds (rows ("whole")));
}

TEST_F (StudyTool, RowsThatAreThereAreKept)
{
  ASSERT_EQ (study ("roof.off -models none -peers 0 -noise GN -seeds 1").status, 0);
  const nlohmann::json before = rows ();
  ASSERT_EQ (study ("roof.off -models none -peers 0 -seeds 1").status, 0);
  const nlohmann::json after = rows ();
  ASSERT_EQ (after.size (), 1088u);
  for (std::size_t i = 0; i < before.size (); ++i)
    EXPECT_EQ (after[i], before[i]); // including the seconds, so it was not computed again
}

TEST_F (StudyTool, BadMeshesAreRowsThatFailed)
{
  writeText (path ("faceless.off"), "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n");
  writeText (path ("damaged.stl"), "hello");
  writeText (path ("tiny.off"), asOff (squareMesh (3)));
  const Ending ending = study (
      "faceless.off damaged.stl missing.ply tiny.off roof.off -models none -peers 0 -sweep 0 -noise GN -seeds 1");
  EXPECT_EQ (ending.status, 0) << ending.err;
  EXPECT_NE (ending.out.find ("8 rows, 4 failed, 0 absent"), std::string::npos) << ending.out;
  for (const char* model : {"faceless", "damaged", "missing", "tiny"})
    EXPECT_NE (ending.err.find (std::string ("model ") + model + " is left out: "), std::string::npos) << ending.err;
  const nlohmann::json all = rows ();
  EXPECT_EQ (all[0].at ("status"), "failed");
  EXPECT_NE (all[0].at ("reason").get<std::string> ().find ("has no faces"), std::string::npos);
  EXPECT_EQ (all[4].at ("model"), "roof");
  EXPECT_EQ (all[4].at ("status"), "ok");
}

TEST_F (StudyTool, Peers)
{
  const std::string command = "roof.off -models none -sweep 0 -noise GN -seeds 2 -small 1";
  ASSERT_EQ (study (command + " -time_limit 0.001").status, 0);
  std::size_t failed = 0;
  for (const nlohmann::json& row : rows ())
    if (row.at ("status") == "failed") {
      ++failed;
      EXPECT_NE (row.at ("reason").get<std::string> ().find ("timed out"), std::string::npos) << row;
      EXPECT_TRUE (row.at ("p2s_mean").is_null ());
    }
  EXPECT_GT (failed, 0u);

  ASSERT_EQ (study (command).status, 0); // the failed rows are tried again
  std::map<std::string, int> seeds;
  for (const nlohmann::json& row : rows ()) {
    EXPECT_NE (row.at ("status"), "failed") << row;
    if (row.at ("family") != "peer" || row.at ("status") != "ok") // absent: MeshLab is not installed everywhere
      continue;
    ++seeds[row.at ("name").get<std::string> ()];
    EXPECT_NE (row.at ("parameters").get<std::string> ().find (" (default)"), std::string::npos) << row;
    EXPECT_TRUE (row.at ("p2s_ratio").is_number ()) << row;
    EXPECT_GT (row.at ("seconds"), 0) << row;
    EXPECT_EQ (row.at ("cloud").get<std::string> ().empty (), row.at ("seed") != 1) << row;
  }
  EXPECT_GE (seeds.size (), 5u);
  for (const auto& [peer, count] : seeds)
    EXPECT_EQ (count, 2) << peer;
  EXPECT_FALSE (std::filesystem::exists (path ("study/work")));
}

TEST_F (StudyTool, AFullDisk)
{
  std::filesystem::create_directory (path ("study"));
  std::filesystem::create_symlink ("/dev/full", path ("study/rows.csv"));
  const Ending ending = study ("roof.off -models none -peers 0 -sweep 0 -seeds 1");
  EXPECT_EQ (ending.status, 2);
  EXPECT_NE (ending.err.find ("rows.csv: cannot be written (No space left on device)"), std::string::npos)
      << ending.err;
}

TEST_F (StudyTool, CloudsThatCannotBeKept)
{
  std::filesystem::create_directory (path ("study"));
  writeText (path ("study/clouds"), "a file in their way");
  const Ending ending = study ("roof.off -models none -peers 0 -sweep 0 -noise GN -seeds 1");
  EXPECT_EQ (ending.status, 0) << ending.err;
  EXPECT_NE (ending.err.find ("going on without that cloud"), std::string::npos) << ending.err;
  EXPECT_EQ (rows ()[1].at ("status"), "ok");
  EXPECT_EQ (rows ()[1].at ("cloud"), "");
}

TEST_F (StudyTool, Usage)
{
  EXPECT_EQ (run ("pcl_smoothing_study").status, 1);
  EXPECT_EQ (study ("-models none").status, 1);
  EXPECT_EQ (study ("-models teapot").status, 1);
  EXPECT_EQ (study ("-sigma 0.2,").status, 1);
  EXPECT_EQ (study ("roof.off roof.off roof.off -subdivide 1,2").status, 1);
  EXPECT_EQ (run ("pcl_smoothing_study -h").status, 0);
  EXPECT_EQ (files (), (std::set<std::string> {"roof.off"}));
}
