// SPDX-License-Identifier: BSD-3-Clause
#include "clouds/cloud_graph.h"
#include "text.h"
#include "tool_runner.h"

#include <nlohmann/json.hpp>

#include <unistd.h>

#include <csignal>

#include <chrono>
#include <filesystem>
#include <thread>

namespace fs = std::filesystem;
using namespace pcl_normal_smoothing;
using test_support::contains;
using Json = nlohmann::json;

namespace
{
class Batch : public ToolTest
{
protected:
  void
  SetUp () override
  {
    fs::create_directory (path ("in.d"));
    for (const char* name : {"a.pcd", "b.PCD", "c.pcd"})
      savePcd (makeWave (), path (std::string ("in.d/") + name));
    writeText (path ("in.d/readme.txt"), "no cloud");
    fs::create_directory (path ("in.d/folder.pcd"));
  }

  Ending
  runBatch (const std::string& options = "") const
  {
    return run ("pcl_normal_smoothing -input_dir in.d -output_dir out.d " + options);
  }

  std::set<std::string>
  outputs () const
  {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator (path ("out.d")))
      names.insert (entry.path ().filename ().string ());
    return names;
  }

  std::string
  summary (const std::string& options = "") const
  {
    const std::string out = runBatch (options).out;
    return out.substr (out.rfind ('\n', out.size () - 2) + 1);
  }
};
} // namespace

TEST_F (Batch, SmoothsEveryCloudAsAlone)
{
  const Ending result = runBatch ("-preset fast -noise_sigma 0.02 -threads 2");
  EXPECT_EQ (result.status, 0) << result.err;
  EXPECT_TRUE (contains (result.out, "[3/3] ")) << result.out;
  EXPECT_EQ (outputs (), (std::set<std::string> {"a.pcd", "a.pcd.json", "b.PCD", "b.PCD.json", "c.pcd", "c.pcd.json"}));
  succeed ("pcl_normal_smoothing in.d/a.pcd alone.pcd -preset fast -noise_sigma 0.02");
  EXPECT_EQ (contentOf (path ("out.d/b.PCD")), contentOf (path ("alone.pcd")));
}

/** As a folder has them that was written in Latin-1. */
TEST_F (Batch, NamesNeedNotBeUtf8)
{
  savePcd (makeWave (), path ("in.d/caf\xe9.pcd"));
  EXPECT_EQ (summary ("-report all.json"), "4 files: 4 smoothed, 0 done before, 0 failed\n");
  EXPECT_EQ (summary (), "4 files: 0 smoothed, 4 done before, 0 failed\n");
  EXPECT_EQ (Json::parse (contentOf (path ("all.json"))).size (), 4u);
}

TEST_F (Batch, DoesNotDoAgainWhatIsDone)
{
  EXPECT_EQ (summary (), "3 files: 3 smoothed, 0 done before, 0 failed\n");
  EXPECT_EQ (summary ("-threads 1"), "3 files: 0 smoothed, 3 done before, 0 failed\n");
  fs::last_write_time (path ("in.d/a.pcd"), fs::file_time_type::clock::now () + std::chrono::hours (1));
  fs::remove (path ("out.d/b.PCD.json")); // as if it had been interrupted
  EXPECT_EQ (summary (), "3 files: 2 smoothed, 1 done before, 0 failed\n");
  EXPECT_EQ (summary ("-preset fast"), "3 files: 3 smoothed, 0 done before, 0 failed\n");
}

TEST_F (Batch, CountsOneFileAsOne)
{
  fs::remove (path ("in.d/a.pcd"));
  fs::remove (path ("in.d/b.PCD"));
  EXPECT_EQ (summary ("-preset fast"), "1 file: 1 smoothed, 0 done before, 0 failed\n");
}

TEST_F (Batch, DoesAgainWhatAnotherVersionDid)
{
  summary ();
  for (const char* version : {"0", "1", "\"0.0.1\""}) {
    Json report = Json::parse (contentOf (path ("out.d/a.pcd.json")));
    report["version"] = Json::parse (version);
    writeText (path ("out.d/a.pcd.json"), report.dump ());
    EXPECT_EQ (summary (), "3 files: 1 smoothed, 2 done before, 0 failed\n") << version;
  }
}

TEST_F (Batch, GoesOnBehindABadFile)
{
  writeText (path ("in.d/bad.ply"), "ply\n");
  writeText (path ("in.d/empty.pcd"), "");
  fs::create_symlink ("nowhere", path ("in.d/link.pcd"));
  const Ending result = runBatch ("-report all.json");
  EXPECT_EQ (result.status, 2);
  for (const char* name : {"in.d/bad.ply: ", "in.d/empty.pcd: ", "in.d/link.pcd: ", "3 of its files"})
    EXPECT_TRUE (contains (result.err, name)) << name << result.err;
  EXPECT_EQ (outputs ().size (), 6u);
  const Json reports = Json::parse (contentOf (path ("all.json")));
  ASSERT_EQ (reports.size (), 6u);
  EXPECT_EQ (reports[0]["points"], 300);
  EXPECT_EQ (reports[2]["exit_status"], 2);
  EXPECT_EQ (summary (), "6 files: 0 smoothed, 3 done before, 3 failed\n");
}

TEST_F (Batch, RefusesFoldersThatCannotBe)
{
  const auto expect = [&] (const std::string& command, int status, const std::string& word) {
    const Ending result = run ("pcl_normal_smoothing " + command);
    EXPECT_EQ (result.status, status) << command;
    EXPECT_TRUE (contains (result.err, word)) << command << "\n" << result.err;
  };
  expect ("-input_dir in.d -output_dir in.d/../in.d", 1, "is the input folder");
  expect ("-input_dir in.d", 1, "go together");
  expect ("in.d/a.pcd x.pcd -input_dir in.d -output_dir out.d", 1, "one or the other");
  expect ("-input_dir none.d -output_dir out.d", 2, "none.d: cannot be read");
  fs::create_directory (path ("empty.d"));
  expect ("-input_dir empty.d -output_dir out.d", 2, "no .pcd or .ply file");
  expect ("-input_dir in.d -output_dir in.d/a.pcd/out.d", 2, "cannot be made");
  EXPECT_FALSE (fs::exists (path ("out.d")));
}

TEST_F (Batch, InterruptedLeavesNothingHalfDone)
{
  RunningTool tool ({TOOLS_FOLDER "/pcl_normal_smoothing", "-input_dir", path ("in.d"), "-output_dir", path ("out.d"),
                     "-update", "paper", "-point_iterations", "1000000"},
                    folder_);
  for (int i = 0; i < 6000 && !fs::exists (path ("out.d")); ++i)
    std::this_thread::sleep_for (std::chrono::milliseconds (10));
  std::this_thread::sleep_for (std::chrono::milliseconds (500));
  tool.send (SIGTERM);
  EXPECT_EQ (tool.wait ().status, 128 + SIGTERM);
  std::this_thread::sleep_for (std::chrono::milliseconds (200));
  EXPECT_EQ (outputs (), std::set<std::string> ());
  EXPECT_EQ (summary (), "3 files: 3 smoothed, 0 done before, 0 failed\n");
}

TEST_F (Batch, ReportTellsWhatWasDone)
{
  succeed ("pcl_normal_smoothing in.d/a.pcd out.pcd -noise_sigma 0.02 -report r.json");
  const Json report = Json::parse (contentOf (path ("r.json")));
  EXPECT_EQ (report["parameters"]["preset"], "default");
  EXPECT_EQ (report["parameters"]["noise_sigma"], 0.02);
  EXPECT_FLOAT_EQ (report["noise"]["sigma"], 0.02f);
  const Json& displacement = report["displacement"];
  EXPECT_EQ (displacement["finite_points"], 298);
  const tools::CloudFile before = readPcdFile (path ("in.d/a.pcd")), after = readPcdFile (path ("out.pcd"));
  double farthest = 0, sum = 0;
  for (std::size_t i = 0; i < before.size (); ++i) {
    const double distance = (positionOf (after, i) - positionOf (before, i)).norm ();
    farthest = std::isfinite (distance) ? std::max (farthest, distance) : farthest;
    sum += std::isfinite (distance) ? distance : 0;
  }
  EXPECT_GT (farthest, 0);
  EXPECT_DOUBLE_EQ (displacement["max"], farthest);
  EXPECT_DOUBLE_EQ (displacement["mean"], sum / 298);
  EXPECT_GE (report["seconds"]["smooth"], 0);
  EXPECT_EQ (run ("pcl_normal_smoothing in.d/a.pcd out.pcd -report in.d/c.pcd").status, 1);
}

TEST_F (Batch, ReportOfThePapersChainEstimatesTheNoise)
{
  succeed ("pcl_normal_smoothing in.d/a.pcd out.pcd -preset paper -report r.json");
  const Json report = Json::parse (contentOf (path ("r.json")));
  EXPECT_GT (report["noise"]["sigma"], 0);
  EXPECT_EQ (report["parameters"]["normal_iterations"], 5);
  for (const double scale : {0x1p-60, 0x1p60}) {
    tools::CloudFile scaled = readPcdFile (path ("in.d/a.pcd"));
    const VectorLayout layout = tools::positionsOf (scaled).layout;
    for (std::size_t i = 0; i < scaled.size (); ++i)
      layout.set (scaled.cloud->data.data (), i, scale * positionOf (scaled, i));
    savePcd (scaled, path ("scaled.pcd"));
    succeed ("pcl_normal_smoothing scaled.pcd out.pcd -preset paper -report scaled.json");
    const Json of_scaled = Json::parse (contentOf (path ("scaled.json")));
    for (const char* name : {"sigma", "spacing"})
      EXPECT_FLOAT_EQ (of_scaled["noise"][name].get<float> () / float (scale), report["noise"][name]) << name << scale;
  }
}
