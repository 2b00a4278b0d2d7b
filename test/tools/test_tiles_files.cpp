// SPDX-License-Identifier: BSD-3-Clause
#include "files/point_stream.h"
#include "files/tool_error.h"
#include "tiles/partition.h"
#include "tiles/plan_options.h"
#include "tiles/spill_file.h"
#include "tiles_fixture.h"

#include <cmath>
#include <filesystem>
#include <random>

using namespace pcl_normal_smoothing;
using namespace pcl_normal_smoothing::tools;

namespace
{
/** Many copies of the wave: several megabytes. */
CloudFile
longWave ()
{
  CloudFile file = makeWave ();
  const std::vector<std::uint8_t> once = file.cloud->data;
  for (int i = 1; i < 150; ++i)
    file.cloud->data.insert (file.cloud->data.end (), once.begin (), once.end ());
  file.cloud->height *= 150;
  return file;
}

std::vector<std::uint8_t>
readInPieces (PointFile& file, std::size_t most)
{
  std::vector<std::uint8_t> all, some;
  while (const std::size_t count = file.read (most, some)) {
    EXPECT_EQ (some.size (), count * file.shape ().point_step);
    all.insert (all.end (), some.begin (), some.end ());
  }
  return all;
}
} // namespace

TEST_F (Tiles, PointsOneAfterTheOther)
{
  const CloudFile wave = longWave ();
  for (const auto& [name, format] : {std::pair ("binary.pcd", FileFormat::BINARY),
                                     {"ascii.pcd", FileFormat::ASCII},
                                     {"binary.ply", FileFormat::BINARY},
                                     {"ascii.ply", FileFormat::ASCII}}) {
    tools::saveCloud (wave, path (name), format);
    const CloudFile whole = loadCloud (path (name));
    PointFile file (path (name));
    EXPECT_TRUE (readInPieces (file, 777) == whole.cloud->data) << name;
    const std::string checksum = file.finish ();
    EXPECT_EQ (file.shape ().width, whole.cloud->width);
    EXPECT_EQ (file.shape ().height, whole.cloud->height);
    EXPECT_EQ (file.shape ().origin, whole.origin);
    EXPECT_EQ (file.shape ().orientation.coeffs (), whole.orientation.coeffs ());

    PointFile again (path (name));
    readInPieces (again, 1 << 20);
    EXPECT_EQ (again.finish (), checksum) << name;
    PointWriter writer (file.shape (), path ("again.d" + std::string (name)), format);
    for (std::size_t i = 0; i < whole.size (); i += 1000)
      writer.write (&whole.cloud->data[i * whole.cloud->point_step], std::min<std::size_t> (1000, whole.size () - i));
    writer.commit ();
    EXPECT_TRUE (contentOf (path ("again.d" + std::string (name))) == contentOf (path (name))) << name;
  }
}

TEST_F (Tiles, SpilledBytesComeBack)
{
  std::vector<std::string> expected (7);
  {
    SpillFile spill (folder_, expected.size (), 1 << 15);
    for (int i = 0; i < 20000; ++i) {
      const std::string text = std::to_string (i) + ",";
      const auto bucket = static_cast<std::size_t> (i * 7919 % 13) % expected.size ();
      expected[bucket] += text;
      spill.add (bucket, text);
    }
    EXPECT_TRUE (files ().empty ()) << "it has a name";
    for (std::size_t bucket = 0; bucket < expected.size (); ++bucket) {
      std::string read;
      spill.read (bucket, [&] (std::string_view bytes) { read += bytes; });
      EXPECT_TRUE (read == expected[bucket]);
      EXPECT_EQ (spill.size (bucket), expected[bucket].size ());
    }
  }
}

TEST_F (Tiles, PartsHoldEquallyManyPoints)
{
  std::mt19937 random (29);
  std::normal_distribution<double> normal (0, 1);
  Cloud cloud;
  for (int i = 0; i < 7000; ++i)
    cloud.emplace_back (std::exp (normal (random)), normal (random), i % 3);
  const Partition partition (cloud, 7);
  ASSERT_EQ (partition.size (), 7u);
  std::vector<int> counts (7);
  for (const auto& point : cloud)
    ++counts[partition.partOf (point)];
  for (const int count : counts)
    EXPECT_NEAR (count, 1000, 10);
  EXPECT_EQ (Partition (Cloud (100, {1, 1, 1}), 5).size (), 1u);
  EXPECT_EQ (Partition ({}, 5).partOf ({0, 0, 0}), 0u);
  Cloud two (99, {0, 0, 0});
  two.emplace_back (0, 1, 0);
  EXPECT_EQ (Partition (two, 4).size (), 2u);
}

TEST_F (Tiles, OptionsComeBackToTheBit)
{
  core::SmoothingOptions options;
  options.in_rounds = true;
  options.normals = NormalSource::HOUGH;
  options.hough.seed = 0xfedcba9876543210u;
  options.filter.weight = NormalWeight::MIXED;
  options.filter.sigma_s = 1.0f / 3;
  options.update.sigma_s = std::nextafter (0.1f, 1.0f);
  options.rounds.noise = {1e-42f, 3.4e38f, {{{{{0.1f, -2, 3e-40f}, 0.3f, 1.0f / 3}}}}};
  options.noise_varies = true;
  options.rounds.fast = true;
  options.rounds.max_displacement = 0.7f;
  const Json json = optionsAsJson (options);
  const core::SmoothingOptions read = optionsFromJson (Json::parse (json.dump ()));
  EXPECT_EQ (optionsAsJson (read).dump (), json.dump ());
  EXPECT_EQ (read.rounds.noise.sigma, options.rounds.noise.sigma);
  ASSERT_EQ (read.rounds.noise.field.factors.regions.size (), 1u);
  EXPECT_EQ (read.rounds.noise.field.factors.regions[0].value, 1.0f / 3);
  EXPECT_TRUE (read.noise_varies);
  EXPECT_EQ (read.rounds.sheet_distance, options.rounds.sheet_distance); // infinity
  EXPECT_EQ (read.hough.seed, options.hough.seed);
  EXPECT_EQ (read.filter.weight, options.filter.weight);
}
