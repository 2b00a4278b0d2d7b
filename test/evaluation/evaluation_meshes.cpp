// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation_meshes.h"

#include <Eigen/Geometry>

#include <sstream>

using namespace pcl_normal_smoothing;

tools::Mesh
squareMesh (std::uint32_t side)
{
  tools::Mesh mesh;
  for (std::uint32_t i = 0; i < side * side; ++i)
    mesh.vertices.emplace_back (i % side / (side - 1.0), i / side / (side - 1.0), 0);
  for (std::uint32_t y = 0; y + 1 < side; ++y)
    for (std::uint32_t x = 0; x + 1 < side; ++x) {
      const std::uint32_t a = y * side + x;
      mesh.triangles.push_back ({a, a + 1, a + side + 1});
      mesh.triangles.push_back ({a, a + side + 1, a + side});
    }
  return mesh;
}

std::string
asOff (const tools::Mesh& mesh)
{
  std::ostringstream text;
  text.precision (17);
  text << "OFF\n" << mesh.vertices.size () << " " << mesh.triangles.size () << " 0\n";
  for (const Eigen::Vector3d& v : mesh.vertices)
    text << v.x () << " " << v.y () << " " << v.z () << "\n";
  for (const auto& [a, b, c] : mesh.triangles)
    text << "3 " << a << " " << b << " " << c << "\n";
  return text.str ();
}

double
volumeOf (const tools::Mesh& mesh)
{
  double volume = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    volume += mesh.vertices[a].dot (mesh.vertices[b].cross (mesh.vertices[c])) / 6;
  return volume;
}
