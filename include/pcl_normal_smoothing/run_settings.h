// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

#include <pcl/PCLPointCloud2.h>

#include <string>
#include <type_traits>
#include <utility>

namespace pcl_normal_smoothing
{
using NeighborGraph = core::NeighborGraph;

/** How a run ended. */
enum class Outcome
{
  DONE,
  CANCELLED,
  FAILED
};

/** What all classes of this module have in common: threads, progress, a shared neighbour graph, the last error. */
class RunSettings
{
public:
  /** Neighbours are closer than this, in the cloud's unit; limits the k nearest. Default 0: no limit. */
  void
  setMaxNeighborDistance (double distance)
  {
    max_neighbor_distance_ = distance;
  }

  double
  getMaxNeighborDistance () const
  {
    return max_neighbor_distance_;
  }

  /** Neighbourhoods that were searched before (buildNeighborGraph), of a cloud with the same points in the same order;
    * k, radius and search method are not used then, but for the later searches of a class that searches anew
    * (setSearchInterval), which ask for k or a radius. Default none. */
  void
  setNeighborGraph (const NeighborGraph::ConstPtr& graph)
  {
    neighbor_graph_ = graph;
  }

  NeighborGraph::ConstPtr
  getNeighborGraph () const
  {
    return neighbor_graph_;
  }

  /** Default 0: all cores; at most 1024 are used. The result does not depend on it. */
  void
  setNumberOfThreads (unsigned int threads = 0)
  {
    threads_ = threads;
  }

  unsigned int
  getNumberOfThreads () const
  {
    return threads_;
  }

  /** Called with the share of the work that is done. Where it returns false the run ends: a filter's output is then its
    * input, a feature's output is empty. Default none. */
  void
  setProgressCallback (const ProgressCallback& progress)
  {
    progress_ = progress;
  }

  /** What went wrong in the last run, and what to do; empty where nothing did. */
  const std::string&
  getErrorMessage () const
  {
    return error_message_;
  }

  /** The progress callback ended the last run. */
  bool
  wasCancelled () const
  {
    return cancelled_;
  }

protected:
  ~RunSettings () = default;

  /** What the last run left is to be forgotten: called when another begins, or fails to. */
  virtual void
  beginRun ()
  {}

  /** Runs \a work; an exception becomes a message under the name of the class. */
  Outcome
  attempt (const std::string& class_name, const std::function<void ()>& work);

  /** Runs a filter of PCL's so that nothing is lost: filtered in place, a cloud stays as it is where that fails;
    * without an input the output is emptied, not left with what it held.
    * \param[in] filter (output): calls PCL's */
  template <typename CloudT, typename Filter>
  void
  filterInto (const std::string& class_name, const CloudT* input, CloudT& output, const Filter& filter)
  {
    if (input && input != &output)
      return filter (output);
    CloudT result;
    if (!input)
      attempt (class_name, [] { failWithoutInput (); });
    else
      filter (result);
    // PCL's filter may have refused the input by itself, without a message: then the result is empty.
    if (!input || (error_message_.empty () && result.width == input->width))
      output = std::move (result);
  }

  core::Execution
  execution () const
  {
    return core::Execution (threads_, progress_);
  }

  /** The graph that was set.
    * \param[in] may_join it may have joined copies of points
    * \throw Error where it is of another cloud than \a cloud, or must not have */
  NeighborGraph::ConstPtr
  fittingGraph (const core::Positions& cloud, bool may_join = false) const;

  /** No points; header and fields stay. */
  template <typename CloudT>
  static void
  emptyCloud (CloudT& cloud)
  {
    if constexpr (std::is_same_v<CloudT, pcl::PCLPointCloud2>) {
      cloud.data.clear ();
      cloud.row_step = 0;
    }
    else
      cloud.points.clear ();
    cloud.width = cloud.height = 0;
  }

  /** What a filter's output is after its run: as it stands, the input where it was cancelled, empty where it failed. */
  template <typename CloudT>
  static void
  settleOutput (Outcome outcome, const CloudT& input, CloudT& output)
  {
    if (outcome == Outcome::CANCELLED)
      output = input;
    if (outcome == Outcome::FAILED)
      emptyCloud (output);
  }

  /** Warns where there are fewer finite points than k.
    * \throw core::Error where there are fewer than 3 */
  static void
  checkPointCount (const std::string& class_name, std::size_t finite_points, std::size_t k);

  /** \throw core::Error always */
  [[noreturn]] static void
  failWithoutInput ();

  double max_neighbor_distance_ = 0;
  NeighborGraph::ConstPtr neighbor_graph_;
  unsigned int threads_ = 0;
  ProgressCallback progress_;
  std::string error_message_;
  bool cancelled_ = false;
};
} // namespace pcl_normal_smoothing
