// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/error.h>
#include <pcl_normal_smoothing/run_settings.h>

#include <pcl/console/print.h>

#include <cmath>
#include <new>

namespace pcl_normal_smoothing
{
Outcome
RunSettings::attempt (const std::string& class_name, const std::function<void ()>& work)
{
  error_message_.clear ();
  cancelled_ = false;
  try {
    work ();
    return Outcome::DONE;
  }
  catch (const core::Cancelled& cancelled) {
    cancelled_ = true;
    error_message_ = cancelled.what ();
    return Outcome::CANCELLED;
  }
  catch (const std::bad_alloc&) {
    error_message_ = "not enough memory: smooth the cloud in parts, or with a smaller k";
  }
  catch (const std::exception& error) {
    error_message_ = error.what ();
  }
  PCL_ERROR ("[pcl_normal_smoothing::%s] %s\n", class_name.c_str (), error_message_.c_str ());
  return Outcome::FAILED;
}

void
RunSettings::failWithoutInput ()
{
  throw core::Error ("no input cloud is set: call setInputCloud");
}

NeighborGraph::ConstPtr
RunSettings::fittingGraph (const core::Positions& cloud, bool may_join) const
{
  if (!may_join && !neighbor_graph_->copies ().points.empty ())
    throw core::Error ("the neighbour graph has one node for points in one place, but here each counts: "
                       "build the graph without NeighborQuery::distinct, or call setNeighborGraph (nullptr)");
  if (neighbor_graph_->cloudSize () != cloud.size ())
    throw core::Error ("the neighbour graph is of a cloud of " + std::to_string (neighbor_graph_->cloudSize ()) +
                       " points, the input has " + std::to_string (cloud.size ()) +
                       ": build the graph from this cloud, or call setNeighborGraph (nullptr)");
  for (const std::uint32_t i : neighbor_graph_->order ())
    if (!cloud.base[i].allFinite ())
      throw core::Error ("point " + std::to_string (i) +
                         " is not finite, but has a row in the neighbour graph: "
                         "build the graph from this cloud, or call setNeighborGraph (nullptr)");
  return neighbor_graph_;
}

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
makeNeighborQuery (int k, double radius, double max_distance)
{
  if (k < 0)
    throw core::Error ("k is " + std::to_string (k) + ": give setKSearch a positive number of neighbours");
  if (!(radius >= 0) || std::isinf (radius))
    throw core::Error ("the radius is " + core::numberText (radius) + ": give setRadiusSearch a positive length");
  if (!(max_distance >= 0))
    throw core::Error ("the maximal neighbour distance is " + core::numberText (max_distance) +
                       ": give setMaxNeighborDistance a positive length, or 0 for no limit");
  if (k > 0 && radius > 0)
    throw core::Error ("both k (" + std::to_string (k) + ") and a radius (" + core::numberText (radius) +
                       ") are set: set one of them to 0, or use setMaxNeighborDistance to limit k");
  if (k == 0 && radius == 0)
    throw core::Error ("neither k nor a radius is set: call setKSearch or setRadiusSearch");
  core::NeighborQuery query;
  query.k = static_cast<std::uint32_t> (k);
  if (radius > 0)
    query.radius = floatLength (radius, "the radius", "setRadiusSearch");
  if (max_distance > 0)
    query.radius =
        std::min (query.radius, floatLength (max_distance, "the maximal neighbour distance", "setMaxNeighborDistance"));
  return query;
}

void
warn (const std::string& class_name, const std::string& message)
{
  PCL_WARN ("[pcl_normal_smoothing::%s] %s\n", class_name.c_str (), message.c_str ());
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

void
checkPointCount (const std::string& class_name, std::size_t finite_points, std::size_t k)
{
  const std::string warning = pointCountWarning (finite_points, k);
  if (!warning.empty ())
    warn (class_name, warning);
}
} // namespace pcl_normal_smoothing
