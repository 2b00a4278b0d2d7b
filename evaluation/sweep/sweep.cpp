// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/sweep.h"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <tuple>

namespace pcl_normal_smoothing::evaluation
{
namespace
{
/** Sort key: what combinations share, coarsest first. */
auto
order (const Combination& c)
{
  return std::make_tuple (c.k, c.source, c.weight, c.normal_iterations, c.point_iterations);
}

/** Seconds that \a work takes. */
template <typename Work>
double
timed (const Work& work)
{
  const auto start = std::chrono::steady_clock::now ();
  work ();
  return std::chrono::duration<double> (std::chrono::steady_clock::now () - start).count ();
}

/** Calls \a use for every run of consecutive elements of \a all with the same \a key. */
template <typename Key, typename Use>
void
forEachGroup (const std::vector<Combination>& all, const Key& key, const Use& use)
{
  for (auto begin = all.begin (); begin != all.end ();) {
    const auto end = std::find_if (begin, all.end (), [&] (const auto& c) { return key (c) != key (*begin); });
    use (std::vector<Combination> (begin, end));
    begin = end;
  }
}
} // namespace

Sweep::Sweep (const tools::Points& noisy)
{
  for (const Eigen::Vector3d& point : noisy)
    cloud_.base.push_back (point.cast<float> ());
  cloud_.offset.assign (noisy.size (), Eigen::Vector3f::Zero ());
}

void
Sweep::run (std::vector<Combination> combinations, const Sink& sink)
{
  std::sort (combinations.begin (), combinations.end (),
             [] (const auto& a, const auto& b) { return order (a) < order (b); });
  forEachGroup (
      combinations, [] (const Combination& c) { return c.k; },
      [&] (const std::vector<Combination>& with_k) {
        search_seconds_ = timed ([&] { search (with_k.front ().k); });
        forEachGroup (
            with_k, [] (const Combination& c) { return c.source; },
            [&] (const std::vector<Combination>& group) { runGroup (group, sink); });
      });
}

void
Sweep::search (int k)
{
  core::NeighborQuery query;
  query.k = static_cast<std::uint32_t> (k);
  graph_ = core::NeighborGraph::build (cloud_, query, execution_);
  nodes_ = core::gather (cloud_, graph_->order (), execution_);
}

void
Sweep::runGroup (const std::vector<Combination>& group, const Sink& sink)
{
  core::Vectors estimated;
  const double estimation_seconds = timed ([&] {
    const core::SmoothingOptions options = group.front ().options ();
    estimated =
        core::estimateNormals (*graph_, nodes_, core::makeEstimator (options.normals, options.hough), execution_);
  });
  forEachGroup (
      group, [] (const Combination& c) { return c.weight; },
      [&] (const std::vector<Combination>& weight) {
        filterAndMove (weight, estimated, search_seconds_ + estimation_seconds, sink);
      });
}

void
Sweep::filterAndMove (const std::vector<Combination>& group, core::Vectors normals, double seconds, const Sink& sink)
{
  int done = 0;
  forEachGroup (
      group, [] (const Combination& c) { return c.normal_iterations; },
      [&] (const std::vector<Combination>& same_normals) {
        core::NormalFilterOptions filter = same_normals.front ().options ().filter;
        filter.iterations -= done;
        done += filter.iterations;
        seconds += timed ([&] { core::filterNormals (*graph_, nodes_, filter, execution_, normals); });
        moveAndSink (same_normals, normals, seconds, sink);
      });
}

void
Sweep::moveAndSink (const std::vector<Combination>& group,
                    const core::Vectors& normals,
                    double seconds,
                    const Sink& sink)
{
  // A single update with the largest number of iterations, observed wherever a smaller number would end. Restarting
  // from there would round differently, as displacements count from the start.
  core::PointUpdateOptions update = group.back ().options ().update;
  for (const Combination& combination : group)
    update.search_interval = std::gcd (update.search_interval, combination.point_iterations);
  core::Positions moved = nodes_;
  auto next = group.begin ();
  int done = 0;
  auto start = std::chrono::steady_clock::now ();
  const auto look = [&] (const core::Positions& positions) {
    seconds += std::chrono::duration<double> (std::chrono::steady_clock::now () - start).count ();
    done += update.search_interval;
    for (; next != group.end () && next->point_iterations == done; ++next) {
      Smoothed result = resultOf (positions, normals);
      result.seconds = seconds;
      sink (*next, result);
    }
    start = std::chrono::steady_clock::now ();
    return graph_;
  };
  core::updatePoints (graph_, normals, update, look, execution_, moved);
  look (moved);
}

Smoothed
Sweep::resultOf (const core::Positions& moved, const core::Vectors& normals) const
{
  Smoothed result {tools::Points (moved.size ()), tools::Points (moved.size ()), 0};
  for (std::size_t node = 0; node < moved.size (); ++node) {
    const std::uint32_t i = graph_->order ()[node];
    const Eigen::Vector3d position = moved.base[node].cast<double> () + moved.offset[node].cast<double> ();
    result.points[i] = position.cast<float> ().cast<double> (); // rounded to float, as the class does
    result.normals[i] =
        normals[node].allFinite () ? Eigen::Vector3d (normals[node].cast<double> ()) : Eigen::Vector3d (0, 0, 0);
  }
  return result;
}

} // namespace pcl_normal_smoothing::evaluation
