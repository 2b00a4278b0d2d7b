// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_graph.h"

#include "command_line/tool.h"
#include "files/field_values.h"

#include <core/noise/noise_sample.h>
#include <pcl_normal_smoothing/core/error.h>
#include <pcl_normal_smoothing/input_checks.h>

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
  return VectorLayout::require (*file.cloud, position_fields,
                                "give a cloud of points, or rename and convert its fields");
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
  return VectorLayout::require (*file.cloud, normal_fields, advice);
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
  const core::Positions cloud = readPositions (positionsOf (file), execution.silent ());
  CloudGraph result;
  result.graph = core::NeighborGraph::build (cloud, query.inUnit (cloud.unit), execution);
  checkPointCount (result.graph->finiteCount (), query.k);
  result.nodes = core::gather (cloud, result.graph->order (), execution.silent ());
  return result;
}

core::NoiseEstimate
estimateNoise (const CloudFile& file, const core::Execution& execution)
{
  core::NeighborQuery query {core::noise_row_length};
  query.distinct = true;
  const CloudGraph cloud = searchNeighbors (file, query, execution.part (0, 0.9));
  return core::estimateNoise (*cloud.graph, cloud.nodes, execution.part (0.9, 1)).inCloudUnit (cloud.nodes.unit);
}

std::string
textOf (core::NoiseHiddenBy hidden_by)
{
  switch (hidden_by) {
  case core::NoiseHiddenBy::LAYERS:
    return "coordinates in steps, as a depth camera gives them";
  case core::NoiseHiddenBy::LINES:
    return "points on lines, as those of a lidar or a profiler";
  case core::NoiseHiddenBy::ROUNDING:
    return "rounded coordinates, as those of voxels or of few digits";
  case core::NoiseHiddenBy::WIDTH:
    return "noise wider than the points are apart, everywhere or in places";
  case core::NoiseHiddenBy::NOTHING:
    break;
  }
  return {};
}

void
addNormalFields (CloudFile& file, const std::vector<std::string>& more)
{
  std::vector<std::string> names (normal_fields.begin (), normal_fields.end ());
  names.insert (names.end (), more.begin (), more.end ());
  addFloatFields (*file.cloud, names);
}

CloudFile
loadInput (const std::string& path)
{
  CloudFile file = loadCloud (path);
  positionsOf (file); // throws if there are none
  if (file.faces > 0)
    note (path + ": " + counted (file.faces, "face is", "faces are") + " ignored, its vertices are the cloud");
  return file;
}

void
saveResult (const CloudFile& file, const std::string& path, FileFormat format)
{
  saveCloud (file, path, format);
  std::printf ("%s: %s\n", path.c_str (), counted (file.size (), "point").c_str ());
}
} // namespace tools
} // namespace pcl_normal_smoothing
