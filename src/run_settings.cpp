// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/error.h>
#include <pcl_normal_smoothing/input_checks.h>
#include <pcl_normal_smoothing/run_settings.h>

#include <pcl/console/print.h>

#include <new>

namespace pcl_normal_smoothing
{
Outcome
RunSettings::attempt (const std::string& class_name, const std::function<void ()>& work)
{
  error_message_.clear ();
  cancelled_ = false;
  beginRun ();
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

void
RunSettings::checkPointCount (const std::string& class_name, std::size_t finite_points, std::size_t k)
{
  const std::string warning = pointCountWarning (finite_points, k);
  if (!warning.empty ())
    PCL_WARN ("[pcl_normal_smoothing::%s] %s\n", class_name.c_str (), warning.c_str ());
}
} // namespace pcl_normal_smoothing
