// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "differences.h"

#include <optional>

namespace pcl_normal_smoothing
{
namespace core
{
/** \param[in] differences at least nearest_count
  * \return the normal of the plane in which so many nearest lie exactly, where they do and span one */
std::optional<Eigen::Vector3d>
planeOf (const Differences& differences);

/** What is around a node that lies in a plane with its nearest. */
struct LayerSurrounding
{
  /** Some points lie off the plane. */
  bool is_off;
  /** To the layer that begins where that of the node ends, > 0: points off the plane lie in one more plane above or
    * below, and to one side. 0: there is none. */
  double step;
};

/** Points that lie in planes and have others off these show layers where there are more of them than so many, and
  * more than such a share of them see a layer next to theirs. Clean surfaces come to .03, depth cameras to .13 and
  * more. */
constexpr double min_count_off = 32, min_share_stepped = .1;

/** \param[in] differences at least nearest_count
  * \param[in] normal of the plane */
LayerSurrounding
layerSurrounding (const Differences& differences, const Eigen::Vector3d& normal);
} // namespace core
} // namespace pcl_normal_smoothing
