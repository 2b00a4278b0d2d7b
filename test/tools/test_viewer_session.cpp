// SPDX-License-Identifier: BSD-3-Clause
#include "tool_runner.h"
#include "viewer/colour_scale.h"
#include "viewer/session.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace pcl_normal_smoothing;
using Given = std::map<std::string, std::string>;

namespace
{
class ViewerSessionTest : public ToolTest
{
protected:
  void
  SetUp () override
  {
    savePcd (makeWave (), path ("wave.pcd"));
  }

  /** The bytes of the tool's output for the wave. */
  std::string
  toolsResult (const Given& options)
  {
    std::string command = "pcl_normal_smoothing wave.pcd out.pcd";
    for (const auto& [name, value] : options)
      command += " " + name + " " + value;
    succeed (command);
    const auto cloud = readPcdFile (path ("out.pcd")).cloud;
    return {cloud->data.begin (), cloud->data.end ()};
  }

  static std::string
  resultOf (const tools::ViewerSession& session)
  {
    const auto& data = session.smoothedCloud ().cloud->data;
    return {data.begin (), data.end ()};
  }
};
} // namespace

TEST_F (ViewerSessionTest, SmoothsAsTheToolWhateverCameBefore)
{
  tools::ViewerSession session (path ("wave.pcd"), "");
  for (const Given& options :
       {Given {}, Given {{"-k", "10"}}, Given {{"-preset", "fast"}}, Given {{"-preset", "paper"}},
        Given {{"-k", "10"}, {"-noise_sigma", "0.05"}}, Given {{"-radius", "1.1"}}, Given {}}) {
    session.smooth (options);
    EXPECT_EQ (resultOf (session), toolsResult (options)) << session.parameters ();
  }
}

TEST_F (ViewerSessionTest, SavesNormalsWhereAskedTo)
{
  tools::ViewerSession session (path ("wave.pcd"), "");
  session.smooth ({{"-save_normals", "1"}});
  EXPECT_EQ (resultOf (session), toolsResult ({{"-save_normals", "1"}}));
}

TEST_F (ViewerSessionTest, WhatCannotBeDoneChangesNothing)
{
  tools::ViewerSession session (path ("wave.pcd"), "");
  session.smooth ({});
  const std::string before = resultOf (session), parameters = session.parameters ();
  EXPECT_ANY_THROW (session.smooth ({{"-normals", "input"}}));
  EXPECT_ANY_THROW (session.smooth ({{"-k", "2"}}));
  EXPECT_EQ (resultOf (session), before);
  EXPECT_EQ (session.parameters (), parameters);
}

TEST_F (ViewerSessionTest, DisplacementsAreThoseOfTheCloud)
{
  tools::ViewerSession session (path ("wave.pcd"), "");
  session.smooth ({{"-noise_sigma", "0.05"}});
  std::vector<float> shown = session.values (session.smoothed (), tools::Colouring::DISPLACEMENT), expected;
  const tools::CloudFile noisy = tools::loadCloud (path ("wave.pcd"));
  for (std::size_t i = 0; i < noisy.size (); ++i) {
    const double moved = (positionOf (session.smoothedCloud (), i) - positionOf (noisy, i)).norm ();
    if (std::isfinite (moved))
      expected.push_back (static_cast<float> (moved));
  }
  std::sort (shown.begin (), shown.end ());
  std::sort (expected.begin (), expected.end ());
  ASSERT_EQ (shown.size (), expected.size ());
  for (std::size_t i = 0; i < shown.size (); ++i)
    EXPECT_NEAR (shown[i], expected[i], 1e-6) << i;
  EXPECT_GT (expected.back (), 0);
}

TEST_F (ViewerSessionTest, CurvatureFallsWithTheNoise)
{
  succeed ("pcl_make_double_torus mesh.ply");
  succeed ("pcl_add_surface_noise mesh.ply noisy.ply -type GN -sigma 0.2 -seed 1");
  tools::ViewerSession session (path ("noisy.ply"), "");
  session.smooth ({});
  EXPECT_LT (tools::meanOfFinite (session.values (session.smoothed (), tools::Colouring::CURVATURE)),
             0.9 * tools::meanOfFinite (session.values (session.noisy (), tools::Colouring::CURVATURE)));
}

TEST_F (ViewerSessionTest, DistancesAreThoseToTheMesh)
{
  succeed ("pcl_make_double_torus mesh.ply");
  succeed ("pcl_add_surface_noise mesh.ply noisy.ply -type GN -sigma 0.2 -seed 1");
  tools::ViewerSession session (path ("noisy.ply"), path ("mesh.ply"));
  session.smooth ({});
  EXPECT_EQ (session.triangles ().size (), tools::loadMesh (path ("mesh.ply")).triangles.size ());
  const auto before = session.values (session.noisy (), tools::Colouring::DISTANCE);
  const double expected =
      nlohmann::json::parse (succeed ("pcl_smoothing_error mesh.ply noisy.ply -json 1").out).at ("p2s_mean");
  EXPECT_NEAR (tools::meanOfFinite (before), expected, 1e-3 * expected);
  EXPECT_LT (tools::meanOfFinite (session.values (session.smoothed (), tools::Colouring::DISTANCE)), 0.5 * expected);
}

TEST_F (ViewerSessionTest, AMeshOfOtherVerticesHasNoTrianglesToShow)
{
  succeed ("pcl_make_double_torus mesh.ply");
  tools::ViewerSession session (path ("wave.pcd"), path ("mesh.ply"));
  EXPECT_TRUE (session.hasMesh ());
  EXPECT_TRUE (session.triangles ().empty ());
}

TEST (ViewerColours, TheScaleEndsWhereNineteenOfTwentyLie)
{
  std::vector<float> values (100, 1);
  values[3] = 1000;
  EXPECT_EQ (tools::scaleLimit (values), 1);
  values.push_back (std::numeric_limits<float>::quiet_NaN ());
  EXPECT_EQ (tools::scaleLimit (values), 1);
  EXPECT_EQ (tools::scaleLimit (std::vector<float> (10, 0)), 1); // the range must not be empty
  EXPECT_EQ (tools::scaleLimit ({}), 1);
}
