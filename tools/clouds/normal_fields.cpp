// SPDX-License-Identifier: BSD-3-Clause
#include "normal_fields.h"

#include "files/field_values.h"

#include <pcl_normal_smoothing/core/error.h>
#include <pcl_normal_smoothing/core/smoothing.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
/** Stores a number in a field of type float or double. */
void
store (const pcl::PCLPointField& field, double number, std::uint8_t* point)
{
  const auto single = static_cast<float> (number);
  if (field.datatype == pcl::PCLPointField::FLOAT64)
    std::memcpy (point + field.offset, &number, sizeof number);
  else
    std::memcpy (point + field.offset, &single, sizeof single);
}

/** The variation of a point without a surface is NaN. */
bool
hasSurface (const core::LocalSurface& surface)
{
  return !std::isnan (surface.variation);
}
} // namespace

core::Vectors
loadNormals (const core::NeighborGraph& graph, const VectorLayout& normals, const CloudFile& file)
{
  const core::Vectors loaded = readNormals ({normals, file.cloud->data.data (), file.size ()}, graph.order ());
  core::requireNormals (core::countNormals (loaded), NormalSource::INPUT);
  return loaded;
}

void
writeSurfaces (const core::NeighborGraph& graph, const std::vector<core::LocalSurface>& surfaces, CloudFile& file)
{
  core::requireNormals (static_cast<std::size_t> (std::count_if (surfaces.begin (), surfaces.end (), hasSurface)),
                        NormalSource::PCA);
  addNormalFields (file, {"curvature"});
  const VectorLayout normals = normalLayoutOf (file, "remove or rename those that there are");
  const pcl::PCLPointField& curvature = *findField (*file.cloud, "curvature");
  if (curvature.datatype != pcl::PCLPointField::FLOAT32 && curvature.datatype != pcl::PCLPointField::FLOAT64)
    throw core::Error ("its field curvature is neither float nor double: remove or rename it");
  const VectorView positions = positionsOf (file);
  const Eigen::Vector3d origin = file.origin.head<3> ().cast<double> ();
  std::uint8_t* data = file.cloud->data.data ();

  std::vector<core::LocalSurface> of_points (file.size (), core::LocalSurface::invalid ());
  for (std::size_t node = 0; node < surfaces.size (); ++node)
    of_points[graph.order ()[node]] = surfaces[node];
  for (std::size_t i = 0; i < of_points.size (); ++i) {
    const Eigen::Vector3d normal = of_points[i].normal.cast<double> ();
    const bool away = normal.dot (origin - positions.layout.get (data, i)) < 0;
    normals.set (data, i, away ? Eigen::Vector3d (-normal) : normal);
    store (curvature, of_points[i].variation, data + i * file.cloud->point_step);
  }
}
} // namespace tools
} // namespace pcl_normal_smoothing
