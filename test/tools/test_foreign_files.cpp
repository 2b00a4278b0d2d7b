// SPDX-License-Identifier: BSD-3-Clause
#include "files/field_values.h"
#include "files/point_stream.h"
#include "tool_runner.h"

#include <cmath>
#include <random>

using namespace pcl_normal_smoothing;
using Field = pcl::PCLPointField;

namespace
{
constexpr int side = 30;

/** Files as other programs write them. */
class ForeignFiles : public ToolTest
{
protected:
  /** A noisy wave with integer coordinates, ten units per spacing; each line ends with a label. */
  static std::string
  points (const std::string& label = " 7")
  {
    std::mt19937 random (5);
    std::normal_distribution<double> noise (0, 2);
    std::string text;
    for (int i = 0; i < side * side; ++i) {
      const double x = 10 * (i % side), y = 10 * (i / side), z = 300 + 30 * std::sin (x / 60) + noise (random);
      for (const double number : {x, y, z})
        text += std::to_string (std::lround (number)) + " ";
      text += label + "\n";
    }
    return text;
  }

  static std::string
  ply (const std::string& properties, const std::string& faces = "")
  {
    const std::string count = std::to_string (side * side);
    return "ply\nformat ascii 1.0\nelement vertex " + count + "\n" + properties + faces + "end_header\n";
  }

  static std::string
  coordinates (const std::string& type, const std::string& names = "xyz")
  {
    std::string text;
    for (const char name : names)
      text += "property " + type + " " + name + "\n";
    return text + "property uchar label\n";
  }

  /** \return the tool's result for a file with this content */
  tools::CloudFile
  smooth (const std::string& name, const std::string& content) const
  {
    writeText (path (name), content);
    succeed ("pcl_normal_smoothing " + name + " out.pcd");
    return readPcdFile (path ("out.pcd"));
  }

  /** Expects the same result as from floats named x, y, z, with coordinates of this \a type. */
  void
  expectTheSame (const tools::CloudFile& file, std::uint8_t type) const
  {
    const tools::CloudFile usual = smooth ("usual.ply", ply (coordinates ("float")) + points ());
    ASSERT_EQ (file.size (), usual.size ());
    EXPECT_EQ (tools::findField (*file.cloud, "x")->datatype, type);
    EXPECT_EQ (bytesOf (file, "label"), std::string (usual.size (), '\7'));
    double moved = 0;
    for (std::size_t i = 0; i < file.size (); ++i) {
      EXPECT_LT ((positionOf (file, i) - positionOf (usual, i)).norm (), 1e-3) << i;
      moved += std::abs (positionOf (file, i).z () - std::round (positionOf (file, i).z ()));
    }
    EXPECT_GT (moved, 0.1 * side * side); // the results are not rounded to integers
  }
};
} // namespace

TEST_F (ForeignFiles, CoordinatesInCapitals)
{
  expectTheSame (smooth ("a.ply", ply (coordinates ("float", "XYZ")) + points ()), Field::FLOAT32);
}

TEST_F (ForeignFiles, CoordinatesInCapitalsBesideAnotherX)
{
  const std::string count = std::to_string (side * side);
  for (const char* fields : {"x X Y Z", "y X Y Z"}) {
    const std::string header =
        std::string ("FIELDS ") + fields + "\nSIZE 4 4 4 4\nTYPE F F F F\nWIDTH " + count + "\nHEIGHT 1\nDATA ascii\n";
    writeText (path ("a.pcd"), header + points ());
    for (const char* tool : {"pcl_normal_smoothing a.pcd out.pcd", "pcl_normal_smoothing_tiles plan tiles.d a.pcd"}) {
      const Ending refused = run (tool);
      EXPECT_EQ (refused.status, 2) << refused.err;
      EXPECT_NE (refused.err.find (std::string ("has both ") + fields[0] + " and "), std::string::npos) << refused.err;
    }
  }
}

TEST_F (ForeignFiles, WholeNumbers)
{
  expectTheSame (smooth ("a.ply", ply (coordinates ("short")) + points ()), Field::FLOAT32);
  expectTheSame (smooth ("a.ply", ply (coordinates ("int")) + points ()), Field::FLOAT64);
  const std::string count = std::to_string (side * side);
  const std::string pcd = "FIELDS X Y Z label\nSIZE 4 4 2 1\nTYPE U I I U\nWIDTH " + count + "\nHEIGHT 1\nDATA ascii\n";
  expectTheSame (smooth ("a.pcd", pcd + points ()), Field::FLOAT64);
}

TEST_F (ForeignFiles, TypesThatDiffer)
{
  const std::string properties = "property double x\nproperty float y\nproperty float z\nproperty uchar label\n";
  expectTheSame (smooth ("a.ply", ply (properties) + points ()), Field::FLOAT64);
}

TEST_F (ForeignFiles, PieceByPiece)
{
  writeText (path ("a.ply"), ply (coordinates ("int", "XYZ")) + points ());
  const tools::CloudFile whole = tools::loadCloud (path ("a.ply"));
  tools::PointFile file (path ("a.ply"));
  std::vector<std::uint8_t> all, some;
  while (file.read (77, some) > 0)
    all.insert (all.end (), some.begin (), some.end ());
  file.finish ();
  EXPECT_EQ (all, whole.cloud->data);
  EXPECT_EQ (file.shape ().point_step, whole.cloud->point_step);
  EXPECT_EQ (file.shape ().fields[2].name, "z");
}

TEST_F (ForeignFiles, NormalsInCapitals)
{
  const std::string normals = "property float NX\nproperty float NY\nproperty float NZ\n";
  const tools::CloudFile out = smooth ("a.ply", ply (coordinates ("float") + normals) + points (" 7 0 0 1"));
  EXPECT_NE (tools::findField (*out.cloud, "normal_z"), nullptr);
}

TEST_F (ForeignFiles, ByteOrderMark)
{
  expectTheSame (smooth ("a.ply", "\xEF\xBB\xBF" + ply (coordinates ("float")) + points ()), Field::FLOAT32);
}

TEST_F (ForeignFiles, FacesWithMoreThanTheirHeaderSays)
{
  const std::string faces = "element face 2\nproperty list uchar int vertex_indices\nproperty uchar red\n";
  const std::string file = ply (coordinates ("float"), faces) + points (), face = "3 0 1 2 6 0.5 0.5 0.5 0.5 0.5 0.5\n";
  expectTheSame (smooth ("a.ply", file + face + face), Field::FLOAT32);
  writeText (path ("a.ply"), file + face);
  const Ending cut = run ("pcl_normal_smoothing a.ply out.pcd");
  EXPECT_EQ (cut.status, 2);
  EXPECT_NE (cut.err.find ("truncated"), std::string::npos) << cut.err;
}
