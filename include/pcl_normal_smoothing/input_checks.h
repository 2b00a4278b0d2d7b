// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

#include <string>

namespace pcl_normal_smoothing
{
/** Converts a length to float.
  * \param[in] setter that received it, for the message
  * \throw core::Error if float would turn it into 0 or infinity */
float
floatLength (double length, const std::string& name, const std::string& setter);

/** What messages call the three settings of a search. */
struct QueryNames
{
  const char* k = "setKSearch";
  const char* radius = "setRadiusSearch";
  const char* max_distance = "setMaxNeighborDistance";
};

/** \param[in] k number of neighbours, the point itself included; 0: by radius
  * \param[in] radius 0: by k
  * \param[in] max_distance limits k; 0: no limit
  * \param[in] names what the caller's users set them by, for the messages
  * \throw core::Error unless exactly one of k and radius is above 0 and none is negative, or if float cannot hold a
  * length */
core::NeighborQuery
makeNeighborQuery (int k, double radius, double max_distance, const QueryNames& names = {});

/** \return a warning if there are fewer finite points than k, else an empty string
  * \throw core::Error if there are fewer than 3 */
std::string
pointCountWarning (std::size_t finite_points, std::size_t k);
} // namespace pcl_normal_smoothing
