// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_shape.h"

namespace pcl_normal_smoothing
{
namespace tools
{
CloudShape
shapeOf (const CloudFile& file)
{
  return {file.cloud->fields, file.cloud->point_step, file.cloud->width, file.cloud->height,
          file.origin,        file.orientation,       file.faces};
}

void
setShape (const CloudShape& shape, CloudFile& file)
{
  file.cloud->fields = shape.fields;
  file.cloud->point_step = static_cast<pcl::uindex_t> (shape.point_step);
  file.cloud->width = static_cast<pcl::uindex_t> (shape.width);
  file.cloud->height = static_cast<pcl::uindex_t> (shape.height);
  file.cloud->row_step = file.cloud->width * file.cloud->point_step;
  file.origin = shape.origin;
  file.orientation = shape.orientation;
  file.faces = shape.faces;
}

} // namespace tools
} // namespace pcl_normal_smoothing
