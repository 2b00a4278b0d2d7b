// SPDX-License-Identifier: BSD-3-Clause
#include "tool_runner.h"

#include <pcl_normal_smoothing/normal_smoothing.h>

#include <pcl/conversions.h>

#include <cmath>
#include <random>

using namespace pcl_normal_smoothing;

namespace
{
class SmoothingTool : public ToolTest
{
protected:
  void
  SetUp () override
  {
    savePcd (makeWave (), path ("wave.pcd"));
  }

  /** The bytes of the tool's output for the wave. */
  std::string
  smoothed (const std::string& options)
  {
    parameters_ = succeed ("pcl_normal_smoothing " + options).out;
    parameters_.erase (0, parameters_.find ("parameters: ") + 12);
    return contentOf (path ("out.pcd"));
  }

  std::string
  smoothedWave (const std::string& options)
  {
    return smoothed ("wave.pcd out.pcd " + options);
  }

  /** Replaces the wave by heights over a grid of 50 x 50 points. */
  template <typename Heights>
  void
  saveHeights (const Heights& height) const
  {
    pcl::PointCloud<pcl::PointXYZ> cloud;
    for (int i = 0; i < 2500; ++i) {
      const float x = static_cast<float> (i % 50) / 50, y = static_cast<float> (i / 50) / 50;
      cloud.emplace_back (x, y, height (x, y));
    }
    tools::CloudFile file;
    file.cloud = pcl::make_shared<pcl::PCLPointCloud2> ();
    pcl::toPCLPointCloud2 (cloud, *file.cloud);
    savePcd (file, path ("wave.pcd"));
  }

  /** Expects what was found in the wave to be printed as \a option 1, which gives the same result; 0 gives another. */
  void
  expectSaid (const std::string& option)
  {
    for (const std::string preset : {"", "-preset fast"}) {
      const std::string expected = smoothedWave (preset), parameters = parameters_;
      EXPECT_NE (parameters.find (option + " 1"), std::string::npos) << parameters;
      EXPECT_TRUE (smoothedWave (parameters) == expected) << parameters;
      EXPECT_EQ (parameters_, parameters);
      EXPECT_TRUE (smoothedWave (option + " 0 " + preset) != expected) << "the test is of no use";
    }
  }

  std::string parameters_;
};

const std::string paper =
    "-normals pca -weights gaussian -k 7 -normal_iterations 5 -point_iterations 7 -threshold 0.65 "
    "-sigma_s 0.3 -mixed printed -update paper -update_sigma_s 0.3333333333333333";
} // namespace

TEST_F (SmoothingTool, PresetPaperIsThisListOfOptions)
{
  EXPECT_EQ (smoothedWave ("-preset paper"), smoothedWave (paper));
  EXPECT_EQ (smoothedWave ("-preset paper"), smoothedWave ("-preset fast " + paper));
  EXPECT_NE (smoothedWave ("-preset paper"), smoothedWave ("-preset default"));
}

TEST_F (SmoothingTool, OptionsHoldOverPresetsInAnyOrder)
{
  const std::string expected = smoothedWave ("-preset paper -k 9 -weights threshold -threshold 0.5");
  EXPECT_EQ (smoothedWave ("-k 9 -threshold 0.5 -weights threshold -preset paper"), expected);
  EXPECT_EQ (smoothed ("-k 9 wave.pcd -weights threshold -preset paper out.pcd -threshold 0.5"), expected);
  EXPECT_NE (smoothedWave ("-preset paper"), expected);
}

TEST_F (SmoothingTool, PrintedParametersGiveTheSameAgain)
{
  for (const std::string options :
       {"", "-noise_sigma 0.0123456", "-preset fast -noise_sigma 0.02 -point_spacing 0.3", "-sheet_distance inf",
        "-sheet_distance 0.25", "-preset paper", "-preset fast -normals hough -seed 5",
        "-radius 1.1 -weights mixed -mixed rms -sigma_s 0.123456789",
        "-k 9 -max_radius 0.7 -max_displacement 0.01 -update_sigma_s 0.1 -weights threshold"}) {
    const std::string expected = smoothedWave (options), parameters = parameters_;
    EXPECT_EQ (smoothedWave (parameters), expected) << options << "\n" << parameters;
    EXPECT_EQ (parameters_, parameters);
  }
}

TEST_F (SmoothingTool, PrintedParametersSayThatTheNoiseVaries)
{
  std::mt19937 random (1);
  std::normal_distribution<float> noise;
  saveHeights ([&] (float x, float) { return (0.001f + 0.008f * x) * noise (random); });
  expectSaid ("-noise_varies");
}

TEST_F (SmoothingTool, PrintedParametersSayThatLayersAreBridged)
{
  saveHeights (
      [] (float x, float y) { return 0.04f * std::round (10 * x + 2 * y); }); // steps of two spacings, five wide
  expectSaid ("-widen_neighborhoods");
}

TEST_F (SmoothingTool, ThreadsDoNotMatter)
{
  for (const std::string options : {"-normals hough", "-weights mixed -mixed rms", "-preset paper -format compressed"})
    EXPECT_EQ (smoothedWave (options + " -threads 1"), smoothedWave (options + " -threads 2"));
}

TEST_F (SmoothingTool, DoesWhatTheClassDoes)
{
  smoothedWave ("-k 10 -normal_iterations 2 -point_iterations 3 -weights threshold -max_displacement 0.05");
  NormalSmoothing<pcl::PCLPointCloud2> smoothing;
  smoothing.setInputCloud (readPcdFile (path ("wave.pcd")).cloud);
  smoothing.setKSearch (10);
  smoothing.setNormalIterations (2);
  smoothing.setPointIterations (3);
  smoothing.setNormalWeight (NormalWeight::THRESHOLD);
  smoothing.setMaxDisplacement (0.05);
  pcl::PCLPointCloud2 expected;
  smoothing.filter (expected);
  EXPECT_EQ (readPcdFile (path ("out.pcd")).cloud->data, expected.data);
}

TEST_F (SmoothingTool, NoProgressAndNoNoiseOffTheTerminal)
{
  EXPECT_EQ (succeed ("pcl_normal_smoothing wave.pcd out.pcd -noise_sigma 0.02").err, "");
}

TEST_F (SmoothingTool, SaysWhatOptionsOfTheOtherMethodDo)
{
  const auto said = [&] (const std::string& options) {
    return succeed ("pcl_normal_smoothing wave.pcd out.pcd " + options).err;
  };
  EXPECT_NE (said ("-threshold 0.5 -sigma_s 0.2").find ("-threshold -sigma_s: of the paper's chain"),
             std::string::npos);
  EXPECT_NE (said ("-preset paper -noise_sigma 0.1").find ("-noise_sigma: for the rounds"), std::string::npos);
  EXPECT_EQ (said ("-weights gaussian -sigma_s 0.2"), "");
  EXPECT_EQ (said ("-preset paper -sigma_s 0.2"), "");
  EXPECT_EQ (said ("-noise_sigma 0"), "");
}

TEST_F (SmoothingTool, AFolderIsNoCloud)
{
  const Ending ending = run ("pcl_normal_smoothing ./. out.pcd");
  EXPECT_EQ (ending.status, 2);
  EXPECT_NE (ending.err.find ("-input_dir"), std::string::npos) << ending.err;
}

TEST_F (SmoothingTool, SaysThatFacesAreLeftOut)
{
  writeText (path ("mesh.ply"),
             "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
             "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
             "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n");
  EXPECT_NE (succeed ("pcl_normal_smoothing mesh.ply out.pcd").err.find ("2 faces"), std::string::npos);
}
