// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "clouds/cloud_points.h"
#include "sweep/combination.h"

#include <functional>
#include <vector>

namespace pcl_normal_smoothing::evaluation
{

/** The result of one combination. */
struct Smoothed
{
  /** Rounded to float, as in a cloud. */
  tools::Points points;
  /** Zero where a point has none. */
  tools::Points normals;
  /** The time that the combination would take by itself. */
  double seconds = 0;
};

/** Smooths one cloud with many combinations, doing shared work once: the search for each k, the normals for each k and
  * estimator, and the iterations, where each count continues from the previous one. The results are bit for bit those
  * of NormalSmoothing for a cloud of floats. */
class Sweep
{
public:
  using Sink = std::function<void (const Combination&, const Smoothed&)>;

  /** \param[in] noisy finite; rounded to float */
  explicit Sweep (const tools::Points& noisy);

  /** Calls \a sink for every combination, in an order that shares as much work as possible.
    * \param[in] combinations any number of any, each with at least one point iteration */
  void
  run (std::vector<Combination> combinations, const Sink& sink);

private:
  /** Searches the neighbours: sets the graph and the nodes. */
  void
  search (int k);

  /** Runs all combinations of one k and estimator. */
  void
  runGroup (const std::vector<Combination>& group, const Sink& sink);

  /** Runs all of these with one weight, too. */
  void
  filterAndMove (const std::vector<Combination>& group, core::Vectors normals, double seconds, const Sink& sink);

  /** Runs all of these with the same filtered normals. */
  void
  moveAndSink (const std::vector<Combination>& group, const core::Vectors& normals, double seconds, const Sink& sink);

  Smoothed
  resultOf (const core::Positions& moved, const core::Vectors& normals) const;

  core::Execution execution_;
  core::Positions cloud_;
  core::NeighborGraph::ConstPtr graph_;
  core::Positions nodes_;
  double search_seconds_ = 0;
};

} // namespace pcl_normal_smoothing::evaluation
