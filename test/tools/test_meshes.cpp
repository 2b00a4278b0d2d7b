// SPDX-License-Identifier: BSD-3-Clause
#include "clouds/cloud_graph.h"
#include "files/tool_error.h"
#include "meshes/mesh_edges.h"
#include "meshes/mesh_io.h"
#include "meshes/mesh_measures.h"
#include "meshes/surface_noise.h"
#include "tool_runner.h"

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include <cmath>
#include <sstream>

using namespace pcl_normal_smoothing;
using Json = nlohmann::json;

namespace
{
/** A grid of unit squares in the plane z = 0, as quads. */
std::string
planeAsOff (int side)
{
  std::string text =
      "OFF\n# a comment\n" + std::to_string (side * side) + " " + std::to_string ((side - 1) * (side - 1)) + " 0\n";
  for (int i = 0; i < side * side; ++i)
    text += std::to_string (i % side) + " " + std::to_string (i / side) + " 0\n";
  for (int y = 0; y + 1 < side; ++y)
    for (int x = 0; x + 1 < side; ++x) {
      const int i = y * side + x;
      text += "4 " + std::to_string (i) + " " + std::to_string (i + 1) + " " + std::to_string (i + side + 1) + " " +
              std::to_string (i + side) + "\n";
    }
  return text;
}

class Meshes : public ToolTest
{
protected:
  void
  SetUp () override
  {
    writeText (path ("plane.off"), planeAsOff (20));
  }

  /** Writes a cloud of the plane's points lifted to \a height, with normals along x. */
  void
  writeLifted (const std::string& name, double height, int points = 400)
  {
    const std::string count = std::to_string (points);
    std::ostringstream text;
    text << "FIELDS x y z normal_x normal_y normal_z\nSIZE 8 8 8 4 4 4\nTYPE F F F F F F\nWIDTH " << count
         << "\nHEIGHT 1\nPOINTS " << count << "\nDATA ascii\n";
    for (int i = 0; i < points; ++i)
      text << i % 20 << " " << i / 20 << " " << height << " 0 -1 -1\n";
    writeText (path (name), text.str ());
  }

  void
  expectUnreadable (const std::string& name, const std::string& content)
  {
    writeText (path (name), content);
    const Ending result = run ("pcl_add_surface_noise " + name + " out.pcd");
    EXPECT_EQ (result.status, 2) << content << result.err;
    EXPECT_NE (result.err.find (path (name) + ": "), std::string::npos) << result.err;
    EXPECT_EQ (files ().count ("out.pcd"), 0u);
  }
};
} // namespace

TEST_F (Meshes, OrderAndPolygonsOfEveryFormat)
{
  const tools::Mesh off = tools::loadMesh (path ("plane.off"));
  ASSERT_EQ (off.vertices.size (), 400u);
  ASSERT_EQ (off.triangles.size (), 2u * 19 * 19);
  EXPECT_EQ (off.vertices[21], Eigen::Vector3d (1, 1, 0));
  EXPECT_NEAR (tools::area (off), 19 * 19, 1e-9);
  EXPECT_NEAR (tools::meanEdgeLength (off), (2 * 19 * 20 + 19 * 19 * std::sqrt (2)) / (2 * 19 * 20 + 19 * 19), 1e-9);
  EXPECT_EQ (tools::vertexNormals (off)[0], Eigen::Vector3d (0, 0, 1));
  writeText (path ("a.obj"), "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
  EXPECT_EQ (tools::loadMesh (path ("a.obj")).triangles.size (), 2u);
  writeText (path ("a.stl"),
             "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\n"
             "endfacet\nendsolid a\n");
  EXPECT_EQ (tools::loadMesh (path ("a.stl")).vertices.size (), 3u);
  tools::saveMesh (off, path ("a.ply"));
  EXPECT_EQ (tools::loadMesh (path ("a.ply")).triangles, off.triangles);
}

TEST_F (Meshes, AttributesOfOffArePassedOver)
{
  const std::string corners[] = {"0 0 0", "1 0 0", "0 1 0"};
  for (const char* keyword : {"COFF", "# one\n # two\n NOFF", "STOFF", "CNOFF", "STCNOFF", "OFF"})
    for (const char* attributes : {"", " 0", " 255 0 0 255", " 0.5 1e9 0", " 1 2 3 4 5 6 7 8 9"}) {
      std::string text = std::string (keyword) + "\n3 1 0\n";
      for (const std::string& corner : corners)
        text += corner + attributes + "\n";
      writeText (path ("a.off"), text + "3 0 1 2" + attributes + "\n");
      const tools::Mesh mesh = tools::loadMesh (path ("a.off"));
      ASSERT_EQ (mesh.triangles.size (), 1u) << text;
      EXPECT_EQ (mesh.vertices[1], Eigen::Vector3d (1, 0, 0)) << text;
      EXPECT_EQ (mesh.vertices[2], Eigen::Vector3d (0, 1, 0)) << text;
    }
}

TEST_F (Meshes, BinaryOff)
{
  std::string bytes = "OFF BINARY\n";
  const auto append = [&bytes] (auto number) {
    std::reverse_iterator end (reinterpret_cast<const char*> (&number)), begin (end.base () + sizeof number);
    bytes.append (begin, end); // big-endian
  };
  for (const int count : {3, 1, 0})
    append (count);
  for (const float coordinate : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f})
    append (coordinate);
  for (const int corner : {3, 0, 1, 2, 0})
    append (corner);
  writeText (path ("a.off"), bytes);
  EXPECT_EQ (tools::loadMesh (path ("a.off")).vertices[2], Eigen::Vector3d (0, 1, 0));
}

/** As a map has them: in float, the edges would be as short as the steps of the coordinates. */
TEST_F (Meshes, NoiseFarFromTheOriginKeepsItsDigits)
{
  for (const double far : {0., 5e6, 1e39}) {
    std::ostringstream text;
    text << "OFF\n4 2 0\n" << std::fixed;
    for (const auto& [x, y] : {std::pair (0., 0.), {.05, 0.}, {.05, .05}, {0., .05}})
      text << far + x << " " << y << " 0\n";
    writeText (path ("far.off"), text.str () + "3 0 1 2\n3 0 2 3\n");
    succeed ("pcl_add_surface_noise far.off far.pcd -sigma 0.2");
    const tools::CloudFile noisy = tools::loadCloud (path ("far.pcd"));
    const bool wide = noisy.cloud->fields[0].datatype == pcl::PCLPointField::FLOAT64;
    EXPECT_EQ (wide, far > 0);
    const VectorView points = tools::positionsOf (noisy);
    const tools::Mesh mesh = tools::loadMesh (path ("far.off"));
    const auto exact = tools::noisyVertices (mesh, tools::NoiseType::GN, .2 * tools::meanEdgeLength (mesh), 1);
    for (std::size_t i = 0; i < points.size; ++i)
      EXPECT_LE ((points.layout.get (points.data, i) - exact[i]).norm (), wide ? 0 : 1e-8) << far;
  }
}

TEST_F (Meshes, ThatLie)
{
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP () << "AddressSanitizer ends a process that is refused memory, where others get std::bad_alloc";
#endif
  expectUnreadable ("a.off", "OFF\n2000000000 1 0\n0 0 0\n");
  expectUnreadable ("a.off", "OFF\n3 2000000000 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  expectUnreadable ("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n");
  expectUnreadable ("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n");
  expectUnreadable ("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 nan 0\n3 0 1 2\n");
  for (const char* nothing :
       {"", " ", "#", "# a\n", "COFF", "COFF ", "COFF\n3 1 0\n0 0 0 255  0",
        "STSTOFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "NCOFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"})
    expectUnreadable ("a.off", nothing);
  expectUnreadable ("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
  expectUnreadable ("a.obj", "hello\n");
  expectUnreadable ("a.stl", std::string (80, ' ') + "\xff\xff\xff\x7f" + std::string (50, ' '));
  expectUnreadable ("a.ply", "ply\nformat ascii 1.0\nelement vertex 2000000000\nproperty float x\nend_header\n0\n");
  expectUnreadable ("a.ply",
                    "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
                    "end_header\n0 0 0\n");
  expectUnreadable ("a.dae", "");
}

TEST_F (Meshes, Noise)
{
  succeed ("pcl_add_surface_noise plane.off gn.pcd -sigma 0.5 -seed 7");
  succeed ("pcl_add_surface_noise plane.off gr.pcd -sigma 0.5 -seed 7 -type GR");
  const double edge = tools::meanEdgeLength (tools::loadMesh (path ("plane.off")));
  const tools::CloudFile normal = readPcdFile (path ("gn.pcd")), random = readPcdFile (path ("gr.pcd"));
  double square_normal = 0, square_random = 0, sum = 0;
  Eigen::Vector3d directions (0, 0, 0);
  for (std::size_t i = 0; i < 400; ++i) {
    const Eigen::Vector3d clean (double (i % 20), double (i / 20), 0);
    const Eigen::Vector3d a = positionOf (normal, i) - clean, b = positionOf (random, i) - clean;
    EXPECT_EQ (a.head<2> (), Eigen::Vector2d (0, 0)); // only along the normal
    sum += a.z ();
    square_normal += a.squaredNorm ();
    square_random += b.squaredNorm ();
    directions += b.cwiseAbs2 ();
  }
  EXPECT_NEAR (std::sqrt (square_normal / 400) / edge, 0.5, 0.06); // three standard errors of 400 samples
  EXPECT_NEAR (std::sqrt (square_random / 400) / edge, 0.5, 0.06);
  EXPECT_NEAR (sum / 400 / edge, 0, 0.08);
  for (int d = 0; d < 3; ++d)
    EXPECT_NEAR (directions[d] / square_random, 1.0 / 3, 0.1);
  succeed ("pcl_add_surface_noise plane.off again.pcd -sigma 0.5 -seed 7");
  EXPECT_EQ (contentOf (path ("again.pcd")), contentOf (path ("gn.pcd")));
  succeed ("pcl_add_surface_noise plane.off other.pcd -sigma 0.5 -seed 8");
  EXPECT_NE (contentOf (path ("other.pcd")), contentOf (path ("gn.pcd")));
}

TEST_F (Meshes, ErrorsOfAShiftedPlane)
{
  writeLifted ("smoothed.pcd", 0.25);
  writeLifted ("noisy.pcd", -1);
  const std::string text = succeed ("pcl_smoothing_error plane.off smoothed.pcd -noisy noisy.pcd -json 1").out;
  EXPECT_EQ (text.find ('\n'), text.size () - 1) << text;
  const Json errors = Json::parse (text);
  EXPECT_EQ (errors.at ("n"), 400);
  EXPECT_NEAR (errors.at ("mean_edge"), (2 + std::sqrt (2)) / 3, 0.01);
  for (const char* key : {"E_A", "E_k7", "E_k15", "E_k21"})
    EXPECT_NEAR (errors.at (key), 0, 1e-12) << key;
  for (const char* key : {"p2s_mean", "p2s_rms", "p2s_max", "p2s_ratio"})
    EXPECT_NEAR (errors.at (key), 0.25, 1e-9) << key;
  EXPECT_NEAR (errors.at ("angle_mean_deg"), 45, 1e-4);
  const Json without_noisy = Json::parse (succeed ("pcl_smoothing_error plane.off smoothed.pcd -json 1").out);
  EXPECT_FALSE (without_noisy.contains ("p2s_ratio"));
  EXPECT_NE (succeed ("pcl_smoothing_error plane.off smoothed.pcd").out.find ("p2s_mean"), std::string::npos);
}

TEST_F (Meshes, ErrorsFarAway)
{
  const tools::Mesh plane = tools::loadMesh (path ("plane.off"));
  std::ostringstream obj, cloud;
  obj.precision (17);
  cloud.precision (17);
  cloud << "FIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nWIDTH 400\nHEIGHT 1\nPOINTS 400\nDATA ascii\n";
  for (const Eigen::Vector3d& v : plane.vertices) {
    obj << "v " << v.x () + 5e6 << " " << v.y () - 4e6 << " " << v.z () << "\n";
    cloud << v.x () + 5e6 << " " << v.y () - 4e6 << " " << v.z () + 0.01 << "\n";
  }
  for (const auto& [a, b, c] : plane.triangles)
    obj << "f " << a + 1 << " " << b + 1 << " " << c + 1 << "\n";
  writeText (path ("far.obj"), obj.str ());
  writeText (path ("far.pcd"), cloud.str ());
  const Json json = Json::parse (succeed ("pcl_smoothing_error far.obj far.pcd -json 1").out);
  EXPECT_NEAR (json.at ("p2s_mean"), 0.01, 1e-9) << json;
  EXPECT_NEAR (json.at ("p2s_max"), 0.01, 1e-9) << json;
}

TEST_F (Meshes, ErrorsNeedAPointForEveryVertex)
{
  writeLifted ("short.pcd", 0, 399);
  const Ending result = run ("pcl_smoothing_error plane.off short.pcd");
  EXPECT_EQ (result.status, 3);
  EXPECT_NE (result.err.find ("399 points"), std::string::npos) << result.err;
}

TEST_F (Meshes, ErrorsOfAnyPointsOfTheSurface)
{
  writeText (path ("samples.pcd"), "FIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nWIDTH 3\nHEIGHT 1\nPOINTS 3\nDATA ascii\n"
                                   "0.3 0.21 0.1\nnan nan nan\n0.17 0.4 -0.3\n");
  writeLifted ("noisy.pcd", -1);
  const Json json =
      Json::parse (succeed ("pcl_smoothing_error plane.off samples.pcd -samples 1 -noisy noisy.pcd -json 1").out);
  EXPECT_EQ (json.at ("n"), 2) << json;
  EXPECT_NEAR (json.at ("p2s_mean"), 0.2, 1e-9) << json;
  EXPECT_NEAR (json.at ("p2s_max"), 0.3, 1e-9) << json;
  EXPECT_NEAR (json.at ("p2s_ratio"), 0.2, 1e-9) << json;
  EXPECT_FALSE (json.contains ("E_A")) << json;
  writeText (path ("nothing.pcd"), "FIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nWIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA ascii\n"
                                   "nan nan nan\n");
  EXPECT_EQ (run ("pcl_smoothing_error plane.off nothing.pcd -samples 1").status, 3);
}

TEST_F (Meshes, DoubleTorus)
{
  succeed ("pcl_make_double_torus torus.ply");
  const tools::Mesh torus = tools::loadMesh (path ("torus.ply"));
  EXPECT_EQ (torus.vertices.size (), 4350u);
  EXPECT_EQ (torus.triangles.size (), 8704u);                // 2 (V + 2), as required by genus 2
  EXPECT_EQ (tools::edgesOf (torus).size (), 3 * 8704u / 2); // every edge has two triangles: closed
  double volume = 0, smallest_angle = 180;
  for (const auto& t : torus.triangles) {
    volume += torus.vertices[t[0]].dot (torus.vertices[t[1]].cross (torus.vertices[t[2]])) / 6;
    for (std::size_t c = 0; c < 3; ++c) {
      const Eigen::Vector3d u = torus.vertices[t[(c + 1) % 3]] - torus.vertices[t[c]],
                            v = torus.vertices[t[(c + 2) % 3]] - torus.vertices[t[c]];
      smallest_angle = std::min (smallest_angle, std::atan2 (u.cross (v).norm (), u.dot (v)) * 180 / 3.14159265);
    }
  }
  EXPECT_GT (volume, 0.3); // positive: the normals point outwards
  EXPECT_GT (smallest_angle, 20);
  for (const Eigen::Vector3d& p : torus.vertices) {
    const double eight = p.x () * p.x () * (1 - p.x () * p.x ()) - p.y () * p.y ();
    EXPECT_NEAR (eight * eight + 0.64 * p.z () * p.z (), 0.12 * 0.12, 1e-6);
  }
}

TEST_F (Meshes, NoisyTorusIsSmoothed)
{
  succeed ("pcl_make_double_torus torus.ply");
  succeed ("pcl_add_surface_noise torus.ply noisy.ply -type GN");
  succeed ("pcl_normal_smoothing noisy.ply smooth.ply");
  const Json json = Json::parse (succeed ("pcl_smoothing_error torus.ply smooth.ply -noisy noisy.ply -json 1").out);
  EXPECT_LT (json.at ("p2s_ratio"), 0.5) << json;
}
