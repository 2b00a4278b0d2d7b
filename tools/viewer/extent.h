// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "viewer/session.h"

namespace pcl_normal_smoothing
{
namespace tools
{
/** Where a surface is, as a camera needs to know; a few points far off do not count. */
class Extent
{
public:
  explicit Extent (const Surface& surface);

  /** The middle, in the cloud's unit. */
  const Eigen::Vector3d&
  centre () const
  {
    return centre_;
  }

  /** How far it reaches from there along each axis. */
  const Eigen::Vector3d&
  half () const
  {
    return half_;
  }

  /** Where a camera must stand to see it whole, in the middle of its view: from the centre.
    * \param[in] axes of the camera, in its columns: right, up, and from the surface to it
    * \param[in] across, upward slopes of the outermost rays that it sees */
  Eigen::Vector3d
  cameraPlace (const Eigen::Matrix3d& axes, double across, double upward) const;

private:
  Eigen::Vector3d centre_, half_;
  std::vector<Eigen::Vector3d> points_; // some of them, about the centre
};
} // namespace tools
} // namespace pcl_normal_smoothing
