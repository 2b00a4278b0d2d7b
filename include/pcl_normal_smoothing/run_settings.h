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

/** Settings common to all classes of this module: threads, progress, a shared neighbour graph, the farthest neighbour,
  * the last error. Filters have k and the radius from SearchSettings, features from pcl::Feature. */
class RunSettings
{
public:
  /** Neighbours are closer than this, in the cloud's unit, whether they are searched by k or by radius. Default 0: no
    * limit. */
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

  /** Neighbourhoods searched before (buildNeighborGraph), for a cloud with the same points in the same order. Then
    * k, radius and search method are not used, except for later searches of a class that searches again
    * (setSearchInterval), which need k or a radius. Default none. */
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

  /** Default 0: all cores; at most 1024 are used. The result does not depend on the number. */
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

  /** Called with the share of the work done. If it returns false, the run ends: a filter then outputs its input, a
    * feature's output is empty. Default none. */
  void
  setProgressCallback (const ProgressCallback& progress)
  {
    progress_ = progress;
  }

  /** What went wrong in the last run, and what to do about it; empty if nothing did. */
  const std::string&
  getErrorMessage () const
  {
    return error_message_;
  }

  /** Whether the progress callback ended the last run. */
  bool
  wasCancelled () const
  {
    return cancelled_;
  }

protected:
  ~RunSettings () = default;

  /** Forgets the results of the last run: called when another begins, or fails to. */
  virtual void
  beginRun ()
  {}

  /** Runs \a work; an exception becomes a message that begins with the class name. */
  Outcome
  attempt (const std::string& class_name, const std::function<void ()>& work);

  /** Runs one of PCL's filters without loss of data: a cloud filtered in place stays as it is if the filter fails;
    * without an input the output is emptied instead of keeping its content.
    * \param[in] filter (output) calls PCL's */
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
    // PCL's filter may have refused the input without a message: then the result is empty.
    if (!input || (error_message_.empty () && result.width == input->width))
      output = std::move (result);
  }

  core::Execution
  execution () const
  {
    return core::Execution (threads_, progress_);
  }

  /** The graph that was set.
    * \param[in] may_join whether it may have joined copies of points
    * \throw Error if it belongs to another cloud than \a cloud, or has joined copies but must not */
  NeighborGraph::ConstPtr
  fittingGraph (const core::Positions& cloud, bool may_join = false) const;

  /** Removes all points; header and fields stay. */
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

  /** Sets a filter's output after its run: it stays as it is, becomes the input if cancelled, and is emptied on
    * failure. */
  template <typename CloudT>
  static void
  settleOutput (Outcome outcome, const CloudT& input, CloudT& output)
  {
    if (outcome == Outcome::CANCELLED)
      output = input;
    if (outcome == Outcome::FAILED)
      emptyCloud (output);
  }

  /** Warns if there are fewer finite points than k.
    * \throw core::Error if there are fewer than 3 */
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
