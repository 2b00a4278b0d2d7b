// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_points.h"

#include "cloud_graph.h"

#include <pcl_normal_smoothing/core/error.h>

namespace pcl_normal_smoothing
{
namespace tools
{
Points
verticesOf (const CloudFile& file, const Mesh& mesh)
{
  const VectorView positions = positionsOf (file);
  if (positions.size != mesh.vertices.size ())
    throw core::Error ("the mesh has " + std::to_string (mesh.vertices.size ()) + " vertices, but " + file.path +
                       " has " + std::to_string (positions.size) +
                       " points: give the cloud whose point i is vertex i of the mesh, or -samples 1");
  Points points;
  for (std::size_t i = 0; i < positions.size; ++i) {
    points.push_back (positions.layout.get (positions.data, i));
    if (!points.back ().allFinite ())
      throw core::Error ("point " + std::to_string (i) + " of " + file.path +
                         " is not finite: give a cloud that has a place for every vertex");
  }
  return points;
}

Points
finitePointsOf (const CloudFile& file)
{
  const VectorView positions = positionsOf (file);
  Points points;
  for (std::size_t i = 0; i < positions.size; ++i)
    if (const Eigen::Vector3d point = positions.layout.get (positions.data, i); point.allFinite ())
      points.push_back (point);
  if (points.empty ())
    throw core::Error (file.path + " has no finite point");
  return points;
}

std::optional<Points>
normalsOf (const CloudFile& file)
{
  const auto layout = VectorLayout::find (*file.cloud, normal_fields);
  if (!layout)
    return std::nullopt;
  Points normals;
  for (std::size_t i = 0; i < file.size (); ++i) {
    normals.push_back (layout->get (file.cloud->data.data (), i));
    if (!normals.back ().allFinite ())
      normals.back ().setZero ();
  }
  return normals;
}
} // namespace tools
} // namespace pcl_normal_smoothing
