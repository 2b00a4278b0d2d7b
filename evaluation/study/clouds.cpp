// SPDX-License-Identifier: BSD-3-Clause
#include "study/clouds.h"

#include "files/field_values.h"

#include <pcl_normal_smoothing/vector_layout.h>

#include <array>
#include <filesystem>

namespace pcl_normal_smoothing::evaluation
{
namespace
{
/** Adds three float fields that hold one vector per point. */
void
addVectors (const tools::Points& vectors, const std::array<std::string, 3>& names, pcl::PCLPointCloud2& cloud)
{
  tools::addFloatFields (cloud, {names.begin (), names.end ()});
  const VectorLayout layout = *VectorLayout::find (cloud, names);
  for (std::size_t i = 0; i < vectors.size (); ++i)
    layout.set (cloud.data.data (), i, vectors[i]);
}
} // namespace

void
savePoints (const tools::Points& points, const tools::Points& normals, const std::string& path)
{
  tools::CloudFile file;
  file.cloud = pcl::make_shared<pcl::PCLPointCloud2> ();
  file.cloud->width = static_cast<pcl::uindex_t> (points.size ());
  file.cloud->height = 1;
  addVectors (points, {"x", "y", "z"}, *file.cloud);
  if (!normals.empty ())
    addVectors (normals, {"normal_x", "normal_y", "normal_z"}, *file.cloud);
  std::error_code error; // if there is no folder, saveCloud reports it
  std::filesystem::create_directories (std::filesystem::path (path).parent_path (), error);
  tools::saveCloud (file, path, tools::FileFormat::BINARY);
}

} // namespace pcl_normal_smoothing::evaluation
