// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

#include <string>

namespace pcl_normal_smoothing
{
/** A length as the work is done with it.
  * \param[in] setter that it was given to, for the message
  * \throw core::Error where float would make 0 or infinity of it, which it is not */
float
floatLength (double length, const std::string& name, const std::string& setter);

/** \param[in] k number of neighbours, the point itself included; 0 = by radius
  * \param[in] radius 0 = by k
  * \param[in] max_distance limits k; 0 = no limit
  * \throw core::Error unless exactly one of k and radius is above 0, and none below, or float cannot hold a length */
core::NeighborQuery
makeNeighborQuery (int k, double radius, double max_distance);

/** \return what to warn of where there are fewer finite points than k, else nothing
  * \throw core::Error where there are fewer than 3 */
std::string
pointCountWarning (std::size_t finite_points, std::size_t k);
} // namespace pcl_normal_smoothing
