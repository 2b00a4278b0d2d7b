// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "clouds/cloud_points.h"
#include "sweep/combination.h"

#include <functional>
#include <vector>

namespace pcl_normal_smoothing::evaluation
{

/** What one combination made of a cloud. */
struct Smoothed
{
  /** In float, as a cloud holds them. */
  tools::Points points;
  /** Zero where there is none. */
  tools::Points normals;
  /** As long as the combination takes by itself. */
  double seconds = 0;
};

/** Smooths one cloud by many combinations; what they have in common is done once: the search for a k, the normals for a
  * k and an estimator, and iterations, each count going on from the last. The results are bit for bit those of
  * NormalSmoothing for a cloud of floats. */
class Sweep
{
public:
  using Sink = std::function<void (const Combination&, const Smoothed&)>;

  /** \param[in] noisy finite; rounded to float */
  explicit Sweep (const tools::Points& noisy);

  /** Calls \a sink for every combination, in an order that shares as much as it can.
    * \param[in] combinations as many and whichever, with at least one point iteration */
  void
  run (std::vector<Combination> combinations, const Sink& sink);

private:
  /** Sets the graph and the nodes. */
  void
  search (int k);

  /** All with one k and estimator. */
  void
  runGroup (const std::vector<Combination>& group, const Sink& sink);

  /** All with one weight as well. */
  void
  filterAndMove (const std::vector<Combination>& group, core::Vectors normals, double seconds, const Sink& sink);

  /** All with the same filtered normals. */
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
