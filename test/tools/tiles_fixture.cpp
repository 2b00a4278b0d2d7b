// SPDX-License-Identifier: BSD-3-Clause
#include "tiles_fixture.h"

#include <pcl_normal_smoothing/vector_layout.h>

#include <cmath>
#include <filesystem>
#include <random>

using namespace pcl_normal_smoothing;

void
Tiles::saveCloud (const Cloud& cloud, const std::string& name) const
{
  tools::CloudFile file;
  file.cloud = pcl::make_shared<pcl::PCLPointCloud2> ();
  for (const char* field : {"x", "y", "z"}) {
    file.cloud->fields.emplace_back ();
    file.cloud->fields.back ().name = field;
    file.cloud->fields.back ().datatype = pcl::PCLPointField::FLOAT32;
    file.cloud->fields.back ().count = 1;
    file.cloud->fields.back ().offset = file.cloud->point_step;
    file.cloud->point_step += 4;
  }
  file.cloud->height = 1;
  file.cloud->width = static_cast<unsigned> (cloud.size ());
  file.cloud->row_step = file.cloud->width * file.cloud->point_step;
  file.cloud->data.resize (file.cloud->row_step);
  const VectorLayout layout = *VectorLayout::find (*file.cloud, {"x", "y", "z"});
  for (std::size_t i = 0; i < cloud.size (); ++i)
    layout.set (file.cloud->data.data (), i, cloud[i]);
  tools::saveCloud (file, path (name), tools::FileFormat::BINARY);
}

void
Tiles::expectSame (const std::string& file,
                   const std::string& size,
                   const std::string& options,
                   const std::string& extension,
                   const std::string& format) const
{
  const std::string what = file + " " + size + " " + options + " " + extension + " " + format;
  const std::string whole = "whole" + extension, merged = "merged" + extension;
  const Ending expected = succeed ("pcl_normal_smoothing " + file + " " + whole + " " + options + " " + format);
  const Ending plan = succeed ("pcl_normal_smoothing_tiles plan tiles.d " + file + " " + size + " " + options);
  succeed ("pcl_normal_smoothing_tiles run tiles.d");
  succeed ("pcl_normal_smoothing_tiles merge tiles.d -output " + merged + " " + format);
  const std::string content = contentOf (path (merged));
  EXPECT_FALSE (content.empty ());
  EXPECT_TRUE (content == contentOf (path (whole))) << what;
  EXPECT_NE (content, contentOf (path (file))) << what << ": nothing has moved, the test is of no use";
  const auto parameters = [] (const std::string& text) { return text.substr (text.find ("\nparameters: ")); };
  EXPECT_EQ (parameters (plan.out), parameters (expected.out)) << what;
  std::filesystem::remove_all (path ("tiles.d"));
}

std::set<std::string>
Tiles::filesIn (const std::string& folder) const
{
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator (path (folder)))
    names.insert (entry.path ().filename ().string ());
  return names;
}

Tiles::Cloud
Tiles::wavyCloud (std::size_t points)
{
  std::mt19937 random (17);
  const double side = std::sqrt (static_cast<double> (points)) / 4;
  std::uniform_real_distribution<double> place (0, side);
  std::normal_distribution<double> noise (0, 0.04);
  Cloud cloud;
  for (std::size_t i = 0; i < points; ++i) {
    const double x = place (random), y = place (random);
    cloud.emplace_back (x, y, std::sin (x) * std::cos (y) + noise (random));
  }
  return cloud;
}

Tiles::Cloud
Tiles::unevenlyNoisyWave ()
{
  std::mt19937 random (20);
  std::uniform_real_distribution<double> place (0, 12);
  std::normal_distribution<double> noise;
  Cloud cloud;
  for (int i = 0; i < 3000; ++i) {
    const double x = place (random), y = place (random);
    cloud.emplace_back (x, y, std::sin (x) * std::cos (y) + (0.005 + 0.008 * x) * noise (random));
  }
  return cloud;
}

Tiles::Cloud
Tiles::clusters ()
{
  std::mt19937 random (18);
  std::normal_distribution<double> normal (0, 1);
  Cloud cloud;
  const auto addBall = [&] (const Eigen::Vector3d& center, double radius, int points) {
    for (int i = 0; i < points; ++i) {
      const Eigen::Vector3d direction =
          Eigen::Vector3d (normal (random), normal (random), normal (random)).normalized ();
      cloud.push_back (center + radius * (1 + 0.02 * normal (random)) * direction);
    }
  };
  addBall ({0, 0, 0}, 1, 600);
  addBall ({40, 3, 1}, 0.2, 350);
  addBall ({41, 3, 1}, 3, 200);
  addBall ({-500, 80, 20}, 1, 9); // fewer than k
  addBall ({0.5, 0, 900}, 0.1, 1);
  addBall ({0, -7, 0}, 0.01, 250);
  for (int i = 0; i < 40; ++i) // more points than k in one place
    cloud.emplace_back (1.01, 0, 0);
  for (int i = 0; i < 300; i += 3)
    cloud.push_back (cloud[static_cast<std::size_t> (i)]);
  std::shuffle (cloud.begin (), cloud.end (), random);
  return cloud;
}

Tiles::Cloud
Tiles::closeSheets ()
{
  std::mt19937 random (19);
  std::uniform_real_distribution<double> place (0, 0.8);
  std::normal_distribution<double> noise (0, 0.006);
  Cloud cloud;
  for (int i = 0; i < 1600; ++i)
    cloud.emplace_back (place (random), place (random), 0.055 * (i % 2) + noise (random));
  return cloud;
}
