// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "peer.h"

#include <gtest/gtest.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace pcl_normal_smoothing::evaluation
{

using Points = std::vector<Eigen::Vector3d>;

/** Points spread evenly over a sphere of radius 1, in random order, moved by noise of that standard deviation. */
Points
noisySphere (std::size_t count, double sigma);

/** A run with a work folder that must be empty again at the end. */
class PeerTest : public testing::Test
{
protected:
  PeerTest ();

  ~PeerTest () override;

  /** A shell program in the place of the one that holds the peers; it is given method, input, output and values. */
  void
  useWorker (const std::string& script);

  /** A path for files of the test itself. */
  std::string
  file (const std::string& name) const
  {
    return folder_ + '/' + name;
  }

  PeerRun run;

private:
  std::string folder_;
};

} // namespace pcl_normal_smoothing::evaluation
