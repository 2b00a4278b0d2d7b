// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "child_process.h"
#include "files/cloud_io.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

/** What a tool printed, and its exit status (128 + signal if a signal ended it). */
struct Ending
{
  int status = -1;
  std::string out, err;
};

/** A running tool, its streams redirected to files in a folder; killed by the destructor if nobody waited for it. */
class RunningTool
{
public:
  /** \param[in] words its path and its arguments \throw std::runtime_error if it cannot be started */
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

  /** To be called only once. */
  Ending
  wait ();

private:
  test_support::ChildProcess process_;
  std::string folder_;
};

/** Provides each test with a folder of its own, removed afterwards, and with clouds to put there. */
class ToolTest : public testing::Test
{
protected:
  /** \param[in] tools folder of the tools */
  explicit ToolTest (std::string tools = TOOLS_FOLDER);
  ~ToolTest () override;

  std::string
  path (const std::string& name) const
  {
    return folder_ + "/" + name;
  }

  /** Runs a tool. The command is the tool's name and its arguments, separated by spaces; names that contain a dot are
    * taken as files in the test's folder. */
  Ending
  run (const std::string& command) const;

  /** Likewise, and expects success. */
  Ending
  succeed (const std::string& command) const;

  /** Names of the files in the test's folder, except those of the streams. */
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

/** A noisy wave of 20 x 15 points, organised, with NaN in points 7 and 100, and with a viewpoint. Fields: x y z (float
  * or double), rgba, intensity, label (16 bit), quality (8 bit), histogram (3 floats), stamp (double). */
pcl_normal_smoothing::tools::CloudFile
makeWave (std::uint8_t position_type = pcl::PCLPointField::FLOAT32, const Eigen::Vector3d& origin = {0, 0, 0});

/** Write and read PCD files with PCL's own code. */
void
savePcd (const pcl_normal_smoothing::tools::CloudFile& file, const std::string& path, bool binary = true);

pcl_normal_smoothing::tools::CloudFile
readPcdFile (const std::string& path);

/** A position as stored in the cloud. */
Eigen::Vector3d
positionOf (const pcl_normal_smoothing::tools::CloudFile& file, std::size_t i);

/** The bytes of one field, of all points. */
std::string
bytesOf (const pcl_normal_smoothing::tools::CloudFile& file, const std::string& field);
