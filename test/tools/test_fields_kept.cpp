// SPDX-License-Identifier: BSD-3-Clause
#include "files/field_values.h"
#include "tool_runner.h"

#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>

using namespace pcl_normal_smoothing;
using Field = pcl::PCLPointField;

namespace
{
const std::vector<std::string> other_fields {"rgba", "intensity", "label", "quality", "histogram", "stamp"};

/** Expects that nothing has changed but the positions of the finite points, and that these have moved. */
void
expectSmoothed (const tools::CloudFile& before, const tools::CloudFile& after)
{
  EXPECT_EQ (after.cloud->width, 20u);
  EXPECT_EQ (after.cloud->height, 15u);
  for (const std::string& name : other_fields) {
    EXPECT_EQ (bytesOf (before, name), bytesOf (after, name)) << name;
    EXPECT_EQ (tools::findField (*before.cloud, name)->datatype, tools::findField (*after.cloud, name)->datatype)
        << name;
  }
  std::size_t moved = 0;
  for (std::size_t i = 0; i < 300; ++i)
    if (i == 7 || i == 100) {
      EXPECT_TRUE (positionOf (after, i).array ().isNaN ().all ()) << i;
    }
    else
      moved += positionOf (before, i) != positionOf (after, i);
  EXPECT_GT (moved, 290u);
  EXPECT_EQ (before.origin.head<3> (), after.origin.head<3> ());
  EXPECT_LT (before.orientation.angularDistance (after.orientation), 1e-3f); // 0 unless a format stores a matrix
}

class FieldsKept : public ToolTest
{
protected:
  /** Saves the wave with PCL and returns what PCL reads from the file, as PCL rounds the viewpoint. */
  tools::CloudFile
  savedWave (const std::string& name)
  {
    savePcd (makeWave (), path (name));
    return readPcdFile (path (name));
  }
};
} // namespace

TEST_F (FieldsKept, InEveryKindOfPcd)
{
  const tools::CloudFile wave = savedWave ("wave.pcd");
  for (const std::string format : {"ascii", "binary", "compressed"}) {
    succeed ("pcl_normal_smoothing wave.pcd " + format + ".pcd -preset paper -format " + format);
    expectSmoothed (wave, readPcdFile (path (format + ".pcd")));
  }
  // Reading these files again gives the same points, whatever the format.
  for (const std::string format : {"ascii", "compressed"}) {
    succeed ("pcl_normal_smoothing " + format + ".pcd again.pcd -normal_iterations 0 -point_iterations 0");
    EXPECT_EQ (bytesOf (readPcdFile (path ("again.pcd")), "z"), bytesOf (readPcdFile (path ("binary.pcd")), "z"));
  }
}

TEST_F (FieldsKept, FromAsciiAndCompressedPcdOfPcl)
{
  const tools::CloudFile wave = savedWave ("wave.pcd");
  savePcd (makeWave (), path ("text.pcd"), false);
  pcl::PCDWriter ().writeBinaryCompressed (path ("small.pcd"), *wave.cloud, wave.origin, wave.orientation);
  for (const std::string name : {"text", "small"}) {
    succeed ("pcl_normal_smoothing " + name + ".pcd out.pcd -preset paper");
    expectSmoothed (wave, readPcdFile (path ("out.pcd")));
  }
}

TEST_F (FieldsKept, ThroughPly)
{
  const tools::CloudFile wave = savedWave ("wave.pcd");
  for (const std::string format : {"ascii", "binary"}) {
    succeed ("pcl_normal_smoothing wave.pcd wave.ply -point_iterations 0 -format " + format);
    succeed ("pcl_normal_smoothing wave.ply smooth.ply -preset paper -format " + format);
    succeed ("pcl_normal_smoothing smooth.ply out.pcd -point_iterations 0");
    expectSmoothed (wave, readPcdFile (path ("out.pcd")));
  }
}

TEST_F (FieldsKept, PclReadsThePly)
{
  const tools::CloudFile wave = savedWave ("wave.pcd");
  for (const std::string format : {"ascii", "binary"}) {
    succeed ("pcl_normal_smoothing wave.pcd wave.ply -format " + format);
    pcl::PCLPointCloud2 cloud;
    ASSERT_EQ (pcl::io::loadPLYFile (path ("wave.ply"), cloud), 0);
    EXPECT_EQ (cloud.width, 20u);
    EXPECT_EQ (cloud.height, 15u);
    tools::CloudFile file;
    file.cloud = pcl::make_shared<pcl::PCLPointCloud2> (cloud);
    for (const std::string name : {"rgba", "intensity", "label", "quality"})
      EXPECT_EQ (bytesOf (wave, name), bytesOf (file, name)) << name;
  }
}

TEST_F (FieldsKept, FromPlyOfPcl)
{
  tools::CloudFile wave = makeWave ();
  wave.cloud->fields.erase (wave.cloud->fields.begin () + 7); // remove the histogram, which PCL's writer garbles
  for (const bool binary : {false, true}) {
    pcl::PLYWriter writer;
    ASSERT_EQ (writer.write (path ("wave.ply"), *wave.cloud, wave.origin, wave.orientation, binary, true), 0);
    succeed ("pcl_normal_smoothing wave.ply out.pcd");
    const tools::CloudFile out = readPcdFile (path ("out.pcd"));
    EXPECT_EQ (out.cloud->width, 20u);
    EXPECT_EQ (bytesOf (wave, "rgba"), bytesOf (out, "rgba"));
    EXPECT_EQ (bytesOf (wave, "label"), bytesOf (out, "label"));
    EXPECT_LT ((wave.origin - out.origin).norm (), 1e-3f);
    EXPECT_LT (wave.orientation.angularDistance (out.orientation), 1e-2f);
  }
}

TEST_F (FieldsKept, DoublePositionsFarAway)
{
  savePcd (makeWave (Field::FLOAT64), path ("near.pcd"));
  savePcd (makeWave (Field::FLOAT64, {5e6, -4e6, 3e3}), path ("far.pcd"));
  for (const std::string name : {"near", "far"}) // with enough noise for points to move
    succeed ("pcl_normal_smoothing " + name + ".pcd " + name + "_out.pcd -noise_sigma 0.02");
  const tools::CloudFile near = readPcdFile (path ("near_out.pcd")), far = readPcdFile (path ("far_out.pcd"));
  EXPECT_EQ (tools::findField (*far.cloud, "x")->datatype, Field::FLOAT64);
  for (std::size_t i = 0; i < 300; ++i)
    if (i != 7 && i != 100) {
      EXPECT_LT ((positionOf (far, i) - Eigen::Vector3d (5e6, -4e6, 3e3) - positionOf (near, i)).norm (), 1e-6) << i;
    }
}

TEST_F (FieldsKept, SavedNormals)
{
  const tools::CloudFile wave = savedWave ("wave.pcd");
  succeed ("pcl_normal_smoothing wave.pcd out.pcd -preset paper -save_normals 1");
  const tools::CloudFile out = readPcdFile (path ("out.pcd"));
  expectSmoothed (wave, out);
  const std::string before = bytesOf (out, "normal_z");
  EXPECT_EQ (before.size (), 300 * sizeof (float));
  succeed ("pcl_normal_smoothing out.pcd kept.pcd"); // normals were not requested, so they stay as they are
  EXPECT_EQ (bytesOf (readPcdFile (path ("kept.pcd")), "normal_z"), before);
  succeed ("pcl_normal_smoothing out.pcd new.pcd -save_normals 1 -normals pca -normal_iterations 0");
  const tools::CloudFile overwritten = readPcdFile (path ("new.pcd"));
  EXPECT_NE (bytesOf (overwritten, "normal_z"), before);
  EXPECT_EQ (overwritten.cloud->fields.size (), out.cloud->fields.size ());
}
