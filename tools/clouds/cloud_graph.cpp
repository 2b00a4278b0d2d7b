// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_graph.h"

#include "command_line/tool.h"
#include "files/field_values.h"

#include <pcl_normal_smoothing/core/error.h>
#include <pcl_normal_smoothing/run_settings.h>

#include <pcl/common/io.h>

#include <cstdio>

namespace pcl_normal_smoothing
{
namespace tools
{
const char* const normals_advice =
    "estimate them first, with pcl_wpca_normal_estimation or pcl_hough_normal_estimation";

namespace
{
/** Names, types and sizes in bytes, as the header of a PCD file has them. */
std::string
fieldsOf (const pcl::PCLPointCloud2& cloud)
{
  std::string list;
  for (const pcl::PCLPointField& field : cloud.fields)
    list += (list.empty () ? "" : ", ") + field.name + " " + pcl::getFieldType (field.datatype) +
            std::to_string (pcl::getFieldSize (field.datatype));
  return list;
}

/** \throw core::Error with \a advice where the fields are not there, all float or all double */
VectorLayout
layoutOf (const CloudFile& file, const std::array<std::string, 3>& names, const std::string& advice)
{
  const auto layout = VectorLayout::find (*file.cloud, names);
  if (!layout)
    throw core::Error ("the cloud has no fields " + names[0] + ", " + names[1] + ", " + names[2] +
                       " that are all float or all double, but " + fieldsOf (*file.cloud) + ": " + advice);
  return *layout;
}
} // namespace

VectorLayout
positionLayoutOf (const CloudFile& file)
{
  return layoutOf (file, {"x", "y", "z"}, "give a cloud of points, or rename and convert its fields");
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
  return layoutOf (file, {"normal_x", "normal_y", "normal_z"}, advice);
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
    note (path + ": " + counted (file.faces, "face is", "faces are") + " left out, the output is a cloud");
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
