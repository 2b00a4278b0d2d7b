// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "child_process.h"
#include "files/cloud_io.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

/** What a tool left on its streams, and its exit status (128 + signal where a signal ended it). */
struct Ending
{
  int status = -1;
  std::string out, err;
};

/** A tool that was started, its streams in files of a folder; killed where nobody waits for it. */
class RunningTool
{
public:
  /** \param[in] words its path and its arguments \throw std::runtime_error where it cannot be started */
  RunningTool (const std::vector<std::string>& words, std::string folder);

  pid_t
  number () const
  {
    return process_.number ();
  }

  void
  send (int signal) const
  {
    process_.send (signal);
  }

  /** Once. */
  Ending
  wait ();

private:
  test_support::ChildProcess process_;
  std::string folder_;
};

/** A folder of its own for every test, removed behind it, and clouds to put into it. */
class ToolTest : public testing::Test
{
protected:
  /** \param[in] tools the folder that they are in */
  explicit ToolTest (std::string tools = TOOLS_FOLDER);
  ~ToolTest () override;

  std::string
  path (const std::string& name) const
  {
    return folder_ + "/" + name;
  }

  /** Runs a tool: its name, then its command line, words parted by spaces; names with a dot are in the test's
    * folder. */
  Ending
  run (const std::string& command) const;

  /** As above, and expects it to succeed. */
  Ending
  succeed (const std::string& command) const;

  /** Names of the files in the test's folder, those of the streams apart. */
  std::set<std::string>
  files () const;

  std::string folder_;

private:
  std::string tools_;
};

std::string
contentOf (const std::string& path);

void
writeText (const std::string& path, const std::string& text);

/** A noisy wave over 20 x 15 points, organised, with NaN in points 7 and 100 and a viewpoint. Fields: x y z (float or
  * double), rgba, intensity, label (16 bit), quality (8 bit), histogram (3 floats), stamp (double). */
pcl_normal_smoothing::tools::CloudFile
makeWave (std::uint8_t position_type = pcl::PCLPointField::FLOAT32, const Eigen::Vector3d& origin = {0, 0, 0});

/** Writes and reads PCD files with PCL's own code. */
void
savePcd (const pcl_normal_smoothing::tools::CloudFile& file, const std::string& path, bool binary = true);

pcl_normal_smoothing::tools::CloudFile
readPcdFile (const std::string& path);

/** A position as it stands in the cloud. */
Eigen::Vector3d
positionOf (const pcl_normal_smoothing::tools::CloudFile& file, std::size_t i);

/** The bytes of one field of all points. */
std::string
bytesOf (const pcl_normal_smoothing::tools::CloudFile& file, const std::string& field);
