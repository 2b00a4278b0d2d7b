// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud_shape.h"

#include <cstdint>
#include <vector>

namespace pcl_normal_smoothing
{
namespace tools
{
/** Makes the coordinates of a file such that a point can be moved by less than their digits tell: fields x, y, z that
  * are all float or all double.
  *
  * PDAL and others call them X, Y, Z; voxel grids and LAS count them in whole numbers. The new type is float where it
  * holds every number of the old types, else double. Where x, y, z are all float or all double already, and where there
  * are none, nothing changes. */
class CoordinateFields
{
public:
  /** \param[in] stored what the file holds
    * \throw FormatError where it has a field x beside those called X, Y, Z: which of them is meant is not told */
  explicit CoordinateFields (const CloudShape& stored);

  /** \param[in] stored what the file holds, which may have learnt its width, height and viewpoint since
    * \return the same with the new fields */
  CloudShape
  shapeFrom (const CloudShape& stored) const;

  /** \param[in,out] data of points as the file holds them; then as shapeFrom () says */
  void
  convert (std::vector<std::uint8_t>& data) const;

private:
  /** \throw FormatError where another field has that name */
  void
  rename (std::size_t field, const std::string& name);

  std::vector<pcl::PCLPointField> stored_, fields_;
  std::size_t stored_step_, step_;
  bool converts_ = false; // else only names change
};
} // namespace tools
} // namespace pcl_normal_smoothing
