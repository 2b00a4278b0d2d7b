// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "viewer/session.h"

namespace pcl_normal_smoothing
{
namespace tools
{
/** Where a surface lies, for placing a camera; a few outlying points are ignored. */
class Extent
{
public:
  explicit Extent (const Surface& surface);

  /** In the cloud's unit. */
  const Eigen::Vector3d&
  centre () const
  {
    return centre_;
  }

  /** How far the surface extends from the centre along each axis. */
  const Eigen::Vector3d&
  half () const
  {
    return half_;
  }

  /** Where a camera must stand, relative to the centre, to see all of the surface in the middle of its view.
    * \param[in] axes of the camera, as columns: right, up, and from the surface to it
    * \param[in] across, upward slopes of the outermost rays that it sees */
  Eigen::Vector3d
  cameraPlace (const Eigen::Matrix3d& axes, double across, double upward) const;

private:
  Eigen::Vector3d centre_, half_;
  std::vector<Eigen::Vector3d> points_; // a sample, relative to the centre
};
} // namespace tools
} // namespace pcl_normal_smoothing
