// SPDX-License-Identifier: BSD-3-Clause
#include "peer_fixture.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

namespace pcl_normal_smoothing::evaluation
{
namespace fs = std::filesystem;

Points
noisySphere (std::size_t count, double sigma)
{
  std::mt19937 random (1);
  std::normal_distribution<double> noise (0, sigma);
  const double golden_angle = M_PI * (3 - std::sqrt (5.));
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    const double turns = static_cast<double> (i), z = 1 - (2 * turns + 1) / static_cast<double> (count);
    const double r = std::sqrt (1 - z * z), angle = golden_angle * turns;
    points.push_back ((sigma > 0 ? 1 + noise (random) : 1) *
                      Eigen::Vector3d (r * std::cos (angle), r * std::sin (angle), z));
  }
  std::shuffle (points.begin (), points.end (), random);
  return points;
}

PeerTest::PeerTest ()
{
  std::string name = (fs::temp_directory_path () / "test_peers_XXXXXX").string ();
  if (!::mkdtemp (name.data ()))
    throw std::runtime_error ("no folder for the test");
  folder_ = name;
  run.work_folder = file ("work");
  fs::create_directory (run.work_folder);
  run.time_limit = 60;
}

PeerTest::~PeerTest ()
{
  EXPECT_TRUE (!fs::exists (run.work_folder) || fs::is_empty (run.work_folder))
      << "something is left in the work folder";
  fs::remove_all (folder_);
}

void
PeerTest::useWorker (const std::string& script)
{
  run.worker = file ("worker");
  std::ofstream (run.worker) << "#!/bin/sh\n" << script << '\n';
  fs::permissions (run.worker, fs::perms::owner_all);
}

} // namespace pcl_normal_smoothing::evaluation
