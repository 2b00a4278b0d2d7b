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

/** Evenly spread points on a unit sphere, in random order, with noise of standard deviation \a sigma. */
Points
noisySphere (std::size_t count, double sigma);

/** A run whose work folder must be empty again at the end. */
class PeerTest : public testing::Test
{
protected:
  PeerTest ();

  ~PeerTest () override;

  /** Replaces the program that holds the peers by a shell script, called with method, input, output and values. */
  void
  useWorker (const std::string& script);

  /** Path for a file of the test itself. */
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
