// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_graph.h"

#include "field_values.h"
#include "tool.h"

#include <pcl_normal_smoothing/core/error.h>
#include <pcl_normal_smoothing/run_settings.h>

#include <cstdio>

namespace pcl_normal_smoothing
{
namespace tools
{
const char* const normals_advice =
    "estimate them first, with pcl_wpca_normal_estimation or pcl_hough_normal_estimation";

VectorLayout
positionLayoutOf (const CloudFile& file)
{
  const auto layout = VectorLayout::find (*file.cloud, {"x", "y", "z"});
  if (!layout)
    throw core::Error ("the cloud has no fields x, y, z that are all float or all double: give a cloud of points");
  return *layout;
}

VectorView
positionsOf (const CloudFile& file)
{
  const VectorLayout layout = positionLayoutOf (file);
  if (file.size () == 0)
    throw core::Error ("the cloud is empty: give one that samples a surface");
  return {layout, file.cloud->data.data (), file.size ()};
}

VectorLayout
normalLayoutOf (const CloudFile& file, const std::string& advice)
{
  const auto layout = VectorLayout::find (*file.cloud, {"normal_x", "normal_y", "normal_z"});
  if (!layout)
    throw core::Error ("the cloud has no fields normal_x, normal_y, normal_z that are all float or all double: " +
                       advice);
  return *layout;
}

void
checkPointCount (std::size_t finite_points, std::size_t k)
{
  const std::string warning = pointCountWarning (finite_points, k);
  if (!warning.empty ())
    note (warning);
}

CloudGraph
searchNeighbors (const CloudFile& file, const core::NeighborQuery& query, const core::Execution& execution)
{
  const core::Positions cloud = readPositions (positionsOf (file));
  CloudGraph result;
  result.graph = core::NeighborGraph::build (cloud, query.inUnit (cloud.unit), execution);
  checkPointCount (result.graph->finiteCount (), query.k);
  result.nodes = core::gather (cloud, result.graph->order ());
  return result;
}

void
addNormalFields (CloudFile& file, const std::vector<std::string>& more)
{
  std::vector<std::string> names {"normal_x", "normal_y", "normal_z"};
  names.insert (names.end (), more.begin (), more.end ());
  addFloatFields (*file.cloud, names);
}

CloudFile
loadInput (const std::string& path)
{
  CloudFile file = loadCloud (path);
  positionsOf (file); // refuses a cloud without
  if (file.faces > 0)
    note (path + ": its " + std::to_string (file.faces) + " faces are left out, the output is a cloud");
  return file;
}

void
saveResult (const CloudFile& file, const std::string& path, FileFormat format)
{
  saveCloud (file, path, format);
  std::printf ("%s: %zu points\n", path.c_str (), file.size ());
}
} // namespace tools
} // namespace pcl_normal_smoothing
