// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/error.h>
#include <pcl_normal_smoothing/input_checks.h>

#include <algorithm>
#include <cmath>

namespace pcl_normal_smoothing
{
float
floatLength (double length, const std::string& name, const std::string& setter)
{
  const auto result = static_cast<float> (length);
  if ((result == 0 && length != 0) || (std::isinf (result) && !std::isinf (length)))
    throw core::Error (name + " is " + core::numberText (length) + ", which float cannot hold: give " + setter +
                       " one from 1e-38 to 1e38, and the cloud in a unit that fits it");
  return result;
}

core::NeighborQuery
makeNeighborQuery (int k, double radius, double max_distance, const QueryNames& names)
{
  const std::string by_k = names.k, by_radius = names.radius, limit = names.max_distance;
  if (k < 0)
    throw core::Error ("k is " + std::to_string (k) + ": give " + by_k + " a positive number of neighbours");
  if (!(radius >= 0) || std::isinf (radius))
    throw core::Error ("the radius is " + core::numberText (radius) + ": give " + by_radius + " a positive length");
  if (!(max_distance >= 0))
    throw core::Error ("the maximal neighbour distance is " + core::numberText (max_distance) + ": give " + limit +
                       " a positive length, or 0 for no limit");
  if (k > 0 && radius > 0)
    throw core::Error ("both k (" + std::to_string (k) + ") and a radius (" + core::numberText (radius) +
                       ") are set: set one of them to 0, or use " + limit + " to limit k");
  if (k == 0 && radius == 0)
    throw core::Error ("neither k nor a radius is set: give " + by_k + " or " + by_radius + " one");
  core::NeighborQuery query;
  query.k = static_cast<std::uint32_t> (k);
  if (radius > 0)
    query.radius = floatLength (radius, "the radius", by_radius);
  if (max_distance > 0)
    query.radius = std::min (query.radius, floatLength (max_distance, "the maximal neighbour distance", limit));
  return query;
}

std::string
pointCountWarning (std::size_t finite_points, std::size_t k)
{
  if (finite_points < 3)
    throw core::Error ("the input has " + std::to_string (finite_points) +
                       " finite points, a surface needs 3 at least: give a cloud that samples a surface");
  if (finite_points >= k)
    return "";
  return "the input has " + std::to_string (finite_points) + " finite points, fewer than k = " + std::to_string (k) +
         ": every point has all others for neighbours";
}
} // namespace pcl_normal_smoothing
