// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_of_points.h"

#include "cloud_graph.h"

#include <pcl_normal_smoothing/core/error.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_normal_smoothing
{
namespace tools
{
double
floatStep (double number)
{
  const auto size = static_cast<float> (std::abs (number));
  return double {std::nextafter (size, std::numeric_limits<float>::infinity ())} - double {size};
}

CloudFile
cloudOfPoints (const std::vector<Eigen::Vector3d>& points, double resolution)
{
  double farthest = 0;
  for (const Eigen::Vector3d& point : points)
    farthest = std::max (farthest, point.cwiseAbs ().maxCoeff ());
  const bool wide = !(floatStep (farthest) <= resolution); // beyond the range of float the step is no number
  CloudFile file;
  file.cloud = pcl::make_shared<pcl::PCLPointCloud2> ();
  pcl::PCLPointCloud2& cloud = *file.cloud;
  for (const std::string& name : position_fields) {
    pcl::PCLPointField field;
    field.name = name;
    field.offset = cloud.point_step;
    field.datatype = wide ? pcl::PCLPointField::FLOAT64 : pcl::PCLPointField::FLOAT32;
    field.count = 1;
    cloud.fields.push_back (field);
    cloud.point_step += static_cast<pcl::uindex_t> (wide ? sizeof (double) : sizeof (float));
  }
  cloud.width = static_cast<pcl::uindex_t> (points.size ());
  cloud.height = 1;
  cloud.row_step = cloud.width * cloud.point_step;
  cloud.data.resize (points.size () * cloud.point_step);
  const VectorLayout layout = positionLayoutOf (file);
  for (std::size_t i = 0; i < points.size (); ++i)
    if (!layout.set (cloud.data.data (), i, points[i]))
      throw core::Error ("point " + std::to_string (i) +
                         " has coordinates that are not finite: give a mesh without them");
  return file;
}
} // namespace tools
} // namespace pcl_normal_smoothing
