// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation_meshes.h"
#include "files/tool_error.h"
#include "meshes/mesh_measures.h"
#include "results/results.h"
#include "results/study_file.h"
#include "tool_runner.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>

using namespace pcl_normal_smoothing;
using namespace pcl_normal_smoothing::evaluation;

namespace
{
Row
someRow (const std::string& name)
{
  Row row;
  row.model = "a, \"b\"";
  row.points = 25;
  row.noise = "GN";
  row.sigma = 0.2;
  row.seed = 1;
  row.family = "sweep";
  row.name = name;
  row.parameters = "-k 7";
  row.k = 7;
  row.seconds = 0.5;
  row.measures.p2s_mean = 1.0 / 3;
  row.cloud = "clouds/a.ply";
  return row;
}

class ResultFiles : public ToolTest
{};
} // namespace

TEST (Rows, AsALineOfTheTable)
{
  EXPECT_EQ (csvHeader (),
             "model,points,noise,sigma,seed,family,name,parameters,k,normal_iterations,point_iterations,status,reason,"
             "seconds,E_A,E_k7,E_k15,E_k21,p2s_mean,p2s_rms,p2s_max,p2s_ratio,p2p_mean,p2p_ratio,normal_angle,"
             "edge_error,edge_fraction,spacing_p01,own_normal_angle,exact_mean,exact_ratio,cloud");
  EXPECT_EQ (toCsv (someRow ("PTU7")), "\"a, \"\"b\"\"\",25,GN,0.2,1,sweep,PTU7,-k 7,7,,,ok,,0.5,,,,,0.333333333,,,,,,,"
                                       ",,,,,,clouds/a.ply");
}

TEST (Rows, AsJsonAndBack)
{
  Row row = someRow ("PTU7");
  row.status = "failed";
  row.reason = "line 1\nline 2";
  const auto json = toJson (row);
  EXPECT_TRUE (json.at ("E_A").is_null ()); // not 0
  EXPECT_TRUE (json.at ("point_iterations").is_null ());
  const Row back = fromJson (json);
  EXPECT_EQ (toCsv (back), toCsv (row));
  EXPECT_EQ (back.key (), row.key ());
  EXPECT_TRUE (std::isnan (back.measures.area_error));
  Row other = row;
  other.seed = 2;
  EXPECT_NE (other.key (), row.key ());
  other = row;
  other.status = "ok"; // still the same question
  EXPECT_EQ (other.key (), row.key ());
}

TEST_F (ResultFiles, AreTakenUp)
{
  Row failed = someRow ("PTU15");
  failed.status = "failed";
  {
    Results first (folder_);
    first.put (someRow ("PTU7"));
    first.put (failed);
    first.save ();
  }
  EXPECT_EQ (files (), (std::set<std::string> {"rows.csv", "rows.json"}));

  Results second (folder_);
  ASSERT_EQ (second.rows ().size (), 2u);
  EXPECT_TRUE (second.answered (someRow ("PTU7").key ()));
  EXPECT_FALSE (second.answered (failed.key ())); // failed, so it is to be tried again
  EXPECT_FALSE (second.answered (someRow ("PTU21").key ()));
  second.put (someRow ("PTU15"));
  second.save ();
  EXPECT_EQ (second.rows ().size (), 2u); // it replaced the failed row
  const std::string line = toCsv (someRow ("PTU7")) + "\r\n", other = toCsv (someRow ("PTU15")) + "\r\n";
  EXPECT_EQ (contentOf (path ("rows.csv")), csvHeader () + "\r\n" + line + other);
}

TEST_F (ResultFiles, ThatAreDamagedOrFullAreSaidSo)
{
  {
    Results results (folder_);
    results.put (someRow ("PTU7"));
    std::filesystem::create_symlink ("/dev/full", path ("rows.csv"));
    EXPECT_THROW (results.save (), tools::FileError);
  }
  writeText (path ("rows.json"), "[{\"model\": \"a\"");
  EXPECT_THROW (Results {folder_}, tools::FileError);
  writeText (path ("rows.json"), "[{\"model\": \"a\"}]");
  EXPECT_THROW (Results {folder_}, tools::FileError);
}

TEST_F (ResultFiles, AreOfOneStudyAtATime)
{
  const Results results (folder_);
  try {
    Results {folder_};
    FAIL () << "two studies in one folder";
  }
  catch (const tools::FileError& error) {
    EXPECT_NE (std::string (error.what ()).find ("another study"), std::string::npos) << error.what ();
  }
}

TEST_F (ResultFiles, OfOtherModelsOrVersionsAreRefused)
{
  const StudyFile study {"pcl_smoothing_study out", {"GN"}, {0.2}, {1, 2}};
  const Model square {"square", "", squareMesh (10), {}}, other {"other", "", squareMesh (12), {}};
  writeStudyFile (folder_, study, {square});
  writeStudyFile (folder_, {"again", {"GR"}, {0.2}, {1}}, {square, other});
  const auto json = nlohmann::json::parse (contentOf (path ("study.json")));
  EXPECT_EQ (json.at ("models").size (), 2u);
  EXPECT_EQ (json.at ("models")[1].at ("file"), "models/other.ply");
  EXPECT_EQ (json.at ("noises"), (nlohmann::json {"GN", "GR"}));
  EXPECT_EQ (json.at ("seeds"), (nlohmann::json {1, 2}));
  EXPECT_NEAR (json.at ("models")[0].at ("mean_edge").get<double> (), tools::meanEdgeLength (square.mesh), 1e-12);
  const Model moved {"square", "", squareMesh (11), {}};
  EXPECT_THROW (writeStudyFile (folder_, study, {moved}), tools::FileError);
  writeText (path ("study.json"), "{\"version\": \"0.0.0\"}");
  EXPECT_THROW (writeStudyFile (folder_, study, {square}), tools::FileError);
}
