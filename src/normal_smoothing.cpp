// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/error.h>
#include <pcl_normal_smoothing/impl/normal_smoothing.hpp>

#include <pcl/impl/instantiate.hpp>

#include <algorithm>

#include "point_types.h"

namespace pcl_normal_smoothing
{
namespace
{
/** \throw core::Error if the data ends before the last point of the cloud */
void
requireData (const pcl::PCLPointCloud2& cloud)
{
  const std::size_t points_of_row = std::size_t (cloud.width) * cloud.point_step;
  const std::size_t row = std::max<std::size_t> ({cloud.row_step, points_of_row, 1});
  // Compared by division: products of numbers from a damaged header may overflow.
  const std::size_t size = cloud.data.size ();
  if (cloud.height > 0 && (size < points_of_row || (size - points_of_row) / row < cloud.height - 1))
    throw core::Error ("the cloud has " + std::to_string (cloud.data.size ()) + " bytes of data, too few for " +
                       std::to_string (cloud.width) + " x " + std::to_string (cloud.height) + " points of " +
                       std::to_string (cloud.point_step) + " bytes: it is truncated, load it anew");
}

/** A copy of the positions for a search object. */
pcl::PointCloud<pcl::PointXYZ>::Ptr
xyzCloud (const VectorView& view)
{
  const core::Positions positions = readPositions (view);
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>> ();
  for (std::size_t i = 0; i < positions.size (); ++i) {
    const Eigen::Vector3f p = positions.inCloudUnit (i);
    cloud->emplace_back (p.x (), p.y (), p.z ());
  }
  return cloud;
}
} // namespace

void
NormalSmoothing<pcl::PCLPointCloud2>::applyFilter (pcl::PCLPointCloud2& output)
{
  const Outcome outcome = attempt (filter_name_, [&] {
    output = *input_;
    smooth (output);
  });
  settleOutput (outcome, *input_, output);
}

void
NormalSmoothing<pcl::PCLPointCloud2>::smooth (pcl::PCLPointCloud2& output)
{
  const std::size_t size = std::size_t (input_->width) * input_->height;
  const VectorLayout layout =
      VectorLayout::require (*input_, position_fields, "give a cloud of points, or rename and convert its fields");
  requireData (*input_);
  std::optional<VectorView> normals;
  if (options ().normals == NormalSource::INPUT)
    normals = VectorView {VectorLayout::require (*input_, normal_fields,
                                                 "estimate normals first, or choose another normal source"),
                          input_->data.data (), size};
  std::optional<VectorLayout> saved_normals;
  if (save_normals_)
    saved_normals = VectorLayout::require (*input_, normal_fields, "add them before setSaveNormals");

  const VectorView positions {layout, input_->data.data (), size};
  pcl::PointCloud<pcl::PointXYZ>::Ptr searched; // one for all searches
  const SmoothingRun run = runSmoothing (filter_name_, positions, normals, *indices_, [&] {
    searched = searched ? searched : xyzCloud (positions);
    return searched;
  });
  run.writePositions (layout, output.data.data ());
  if (saved_normals)
    run.writeNormals (*saved_normals, output.data.data ());
}
} // namespace pcl_normal_smoothing

PCL_INSTANTIATE (NormalSmoothing, PCL_NORMAL_SMOOTHING_POINT_TYPES)
