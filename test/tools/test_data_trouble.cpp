// SPDX-License-Identifier: BSD-3-Clause
#include "tool_runner.h"

using namespace pcl_normal_smoothing;

namespace
{
const std::vector<std::string> filters {"pcl_normal_smoothing", "pcl_wpca_normal_estimation",
                                        "pcl_hough_normal_estimation", "pcl_bilateral_normal_filter",
                                        "pcl_normal_guided_point_update"};

/** The header of an ASCII file of floats. */
std::string
header (const std::string& fields, std::size_t points)
{
  std::string sizes, types;
  for (const char c : " " + fields)
    if (c == ' ') {
      sizes += " 4";
      types += " F";
    }
  const std::string count = std::to_string (points);
  return "VERSION 0.7\nFIELDS " + fields + "\nSIZE" + sizes + "\nTYPE" + types + "\nWIDTH " + count +
         "\nHEIGHT 1\nPOINTS " + count + "\nDATA ascii\n";
}

class DataTrouble : public ToolTest
{
protected:
  /** Expects status 3, a message that names the file and contains \a word, and no output. */
  void
  expectRefused (const std::string& command, const std::string& word)
  {
    const Ending result = run (command);
    EXPECT_EQ (result.status, 3) << command << "\n" << result.err;
    EXPECT_NE (result.err.find (word), std::string::npos) << command << "\n" << result.err;
    EXPECT_NE (result.err.find (path ("in.")), std::string::npos) << command << "\n" << result.err;
    EXPECT_EQ (files ().count ("out.pcd"), 0u) << command;
    std::size_t lines = 0;
    for (const char c : result.err)
      lines += c == '\n';
    EXPECT_EQ (lines, 1u) << result.err;
  }
};
} // namespace

TEST_F (DataTrouble, NothingToWorkOn)
{
  for (const std::string& tool : filters) {
    const std::string command = tool + " in.pcd out.pcd";
    writeText (path ("in.pcd"), header ("x y z normal_x normal_y normal_z", 0));
    expectRefused (command, "empty");
    writeText (path ("in.pcd"), header ("x y z normal_x normal_y normal_z", 2) + "0 0 0 0 0 1\n1 0 0 0 0 1\n");
    expectRefused (command, "2 finite points");
    writeText (path ("in.pcd"),
               header ("x y z normal_x normal_y normal_z", 3) + "nan 0 0 0 0 1\nnan nan nan 0 0 1\n1 0 inf 0 0 1\n");
    expectRefused (command, "0 finite points");
    writeText (path ("in.pcd"), header ("u v", 3) + "1 2\n3 4\n5 6\n");
    expectRefused (command, "no field x, but u F4, v F4");
  }
  writeText (path ("in.ply"), "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\n"
                              "property float z\nend_header\n");
  expectRefused ("pcl_normal_smoothing in.ply out.pcd", "empty");
}

TEST_F (DataTrouble, NoNormalToWorkWith)
{
  std::string points;
  for (int i = 0; i < 49; ++i)
    points += std::to_string (i % 7) + " " + std::to_string (i / 7) + (i % 2 == 0 ? " 0 0 0 0\n" : " 0 nan 0 1\n");
  writeText (path ("in.pcd"), header ("x y z normal_x normal_y normal_z", 49) + points);
  for (const char* tool :
       {"pcl_normal_smoothing -normals input", "pcl_bilateral_normal_filter", "pcl_normal_guided_point_update"})
    expectRefused (std::string (tool) + " in.pcd out.pcd", "all that are read are zero or not finite");
  for (const char* tool : {"pcl_normal_smoothing", "pcl_wpca_normal_estimation", "pcl_hough_normal_estimation"})
    expectRefused (std::string (tool) + " in.pcd out.pcd -radius 0.001", "give a larger one");
}

TEST_F (DataTrouble, FieldsOfOtherNames)
{
  tools::CloudFile cloud = makeWave ();
  cloud.cloud->fields[3].name = "depth";
  savePcd (cloud, path ("in.pcd"));
  expectRefused ("pcl_normal_smoothing in.pcd out.pcd", "y F4, depth F4");
}

TEST_F (DataTrouble, CoordinatesTooLargeForFloat)
{
  const Eigen::Vector3d utm (500000, 5600000, 100);
  savePcd (makeWave (pcl::PCLPointField::FLOAT32, utm), path ("float.pcd"));
  EXPECT_NE (succeed ("pcl_normal_smoothing float.pcd out.pcd").err.find ("in steps of 0.5 in float"),
             std::string::npos);
  savePcd (makeWave (pcl::PCLPointField::FLOAT64, utm), path ("double.pcd"));
  EXPECT_EQ (succeed ("pcl_normal_smoothing double.pcd out.pcd").err, "");
}

TEST_F (DataTrouble, NoSurface)
{
  std::string points;
  for (int i = 0; i < 60; ++i)
    points += std::to_string (i) + " 0 0\n";
  writeText (path ("in.pcd"), header ("x y z", 60) + points);
  expectRefused ("pcl_normal_smoothing in.pcd out.pcd", "line");
}

TEST_F (DataTrouble, NoNormals)
{
  savePcd (makeWave (), path ("in.pcd"));
  expectRefused ("pcl_bilateral_normal_filter in.pcd out.pcd", "pcl_wpca_normal_estimation");
  expectRefused ("pcl_normal_guided_point_update in.pcd out.pcd", "pcl_wpca_normal_estimation");
  expectRefused ("pcl_normal_smoothing in.pcd out.pcd -normals input", "pcl_wpca_normal_estimation");
}

TEST_F (DataTrouble, FewerPointsThanKIsNoError)
{
  writeText (path ("in.pcd"), header ("x y z", 4) + "0 0 0\n1 0 0\n0 1 0\n1 1 0.1\n");
  const Ending result = succeed ("pcl_normal_smoothing in.pcd out.pcd");
  EXPECT_NE (result.err.find ("fewer than k"), std::string::npos) << result.err;
  EXPECT_EQ (result.err.find ("in steps of"), std::string::npos) << "small coordinates are fine: " << result.err;
}
