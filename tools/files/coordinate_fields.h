// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud_shape.h"

#include <cstdint>
#include <vector>

namespace pcl_normal_smoothing
{
namespace tools
{
/** Converts the coordinates of a file to fields x, y, z that are all float or all double, so that points can be moved
  * by less than the resolution of the file.
  *
  * PDAL and others call the fields X, Y, Z; voxel grids and LAS store whole numbers. The new type is float if it can
  * hold every number of the old types, otherwise double. Nothing changes if x, y, z are all float or all double
  * already, or if there are no coordinates. */
class CoordinateFields
{
public:
  /** \param[in] stored what the file holds
    * \throw FormatError if it has X, Y, Z and some, but not all, of x, y, z: which of them are meant is unknown */
  explicit CoordinateFields (const CloudShape& stored);

  /** \param[in] stored what the file holds; its width, height and viewpoint may have become known since
    * \return the same with the new fields */
  CloudShape
  shapeFrom (const CloudShape& stored) const;

  /** \param[in,out] data points as the file holds them; converted to the fields of shapeFrom () */
  void
  convert (std::vector<std::uint8_t>& data) const;

private:
  /** \throw FormatError if another field has that name */
  void
  rename (std::size_t field, const std::string& name);

  std::vector<pcl::PCLPointField> stored_, fields_;
  std::size_t stored_step_, step_;
  bool converts_ = false; // false: at most names change
};
} // namespace tools
} // namespace pcl_normal_smoothing
