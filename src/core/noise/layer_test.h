// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "differences.h"

#include <optional>

namespace pcl_normal_smoothing
{
namespace core
{
/** \param[in] differences at least nearest_count
  * \return the normal of the plane in which the nearest_count nearest lie exactly; none if they do not, or span no
  * plane */
std::optional<Eigen::Vector3d>
planeOf (const Differences& differences);

/** The surroundings of a node that lies in a plane with its nearest. */
struct LayerSurrounding
{
  /** At least eight points lie off the plane. */
  bool is_off = false;
  /** Distance to a layer that begins where the node's ends, > 0: the points off the plane lie in one more plane
    * above or below, and to one side. 0: there is no such layer. */
  double step = 0;
  /** Distance from the plane to the nearest point off it; 0 unless there are eight. */
  double to_nearest_off = 0;
};

/** Points in planes show layers if more than min_count_off of them have others off their plane, and more than
  * min_share_stepped of these see a layer next to theirs. Clean surfaces have up to .03, depth cameras .13 and more. */
constexpr double min_count_off = 32, min_share_stepped = .1;

/** \param[in] differences at least nearest_count
  * \param[in] normal of the plane */
LayerSurrounding
layerSurrounding (const Differences& differences, const Eigen::Vector3d& normal);
} // namespace core
} // namespace pcl_normal_smoothing
