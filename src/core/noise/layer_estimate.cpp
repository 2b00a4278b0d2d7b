// SPDX-License-Identifier: BSD-3-Clause
#include "../quantile.h"
#include "camera_grid.h"
#include "layer_test.h"
#include "thinned_sample.h"

#include "layer_estimate.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
constexpr double cosine_of_parallel = 1 - 1e-5;
constexpr double cosine_of_facing = .77; // 40 degrees: objects may be at the rim of the picture only
constexpr double min_share_flat = .05;   // with noise there are none; a scan of a table with a frayed wall has .1
// Share of the flat neighbourhoods that must be parallel; on a slanting table, rows of pixels a step apart are flat
// too.
constexpr double min_share_parallel = .12;
constexpr double min_share_off = .1; // share of the flat ones that must have points off their plane nearby
// Share of those seeing a layer that must lie between two; cameras have .8 and more.
constexpr double min_share_between = .5;
// Upper bound on the share of these with their nearest on a line: above it, the planes are those of a profiler's lines.
constexpr double max_share_lines = .6;
constexpr double surely_line = .2;
constexpr float max_deviation = .45f; // median deviation of log (step) from its region's; terraces have more

bool
areParallel (const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return std::abs (a.dot (b)) > cosine_of_parallel;
}

/** One of \a normals, out of some candidates: the one that most others are parallel to. */
Eigen::Vector3d
commonNormal (const std::vector<Eigen::Vector3d>& normals)
{
  constexpr std::size_t candidates = 64;
  Eigen::Vector3d common = Eigen::Vector3d::Zero ();
  std::ptrdiff_t most = 0;
  for (std::size_t i = 0; i < normals.size (); i += std::max<std::size_t> (normals.size () / candidates, 1)) {
    const auto count = std::count_if (normals.begin (), normals.end (),
                                      [&] (const auto& normal) { return areParallel (normal, normals[i]); });
    if (count > most) {
      most = count;
      common = normals[i];
    }
  }
  return common;
}

using Planes = std::vector<std::optional<Eigen::Vector3d>>;

Planes
planesOf (const std::vector<Differences>& differences)
{
  Planes planes;
  std::transform (differences.begin (), differences.end (), std::back_inserter (planes), planeOf);
  return planes;
}

/** Whether steps that are near each other have about the same size. */
bool
areAlike (const std::vector<LocalValue>& steps, float spacing)
{
  const RegionalField usual = regionalMedians (steps, spacing);
  std::vector<float> deviations;
  for (const LocalValue& step : steps)
    deviations.push_back (std::abs (std::log (step.value / usual.valueAt (step.place, step.value))));
  return quantile (deviations, .5) < max_deviation;
}

/** Sigma in steps. With rounding alone all steps are clear; noise added before rounding frays them. */
float
noiseOfStep (double share_stepped)
{
  return static_cast<float> (.29 + .5 * (1 - share_stepped));
}

/** A quick check, which is all that most clouds with noise need. */
bool
mayHaveLayers (const NeighborGraph& graph, const Positions& nodes, const Execution& execution)
{
  if (graph.minRowLength () < nearest_count)
    return false;
  const std::vector<Differences> sample = quickSample (graph, nodes, execution);
  const auto flat = std::count_if (sample.begin (), sample.end (),
                                   [] (const Differences& differences) { return planeOf (differences).has_value (); });
  return static_cast<double> (flat) > min_share_flat * static_cast<double> (sample.size ());
}

/** Whether some of the planes face a camera at the origin to which all points appear a pixel apart. */
bool
areOfCamera (const std::vector<Eigen::Vector3d>& normals,
             const NeighborGraph& graph,
             const Positions& nodes,
             const Execution& execution)
{
  const Eigen::Vector3d direction = viewingDirection (nodes, execution);
  std::vector<Eigen::Vector3d> facing;
  std::copy_if (normals.begin (), normals.end (), std::back_inserter (facing),
                [&] (const auto& normal) { return std::abs (normal.dot (direction)) > cosine_of_facing; });
  return static_cast<double> (facing.size ()) > min_count_off &&
         isGridOfCamera (graph, nodes, commonNormal (facing), execution);
}

/** Points that lie in parallel planes with their nearest, and their surroundings. */
class ParallelPlanes
{
public:
  /** \param[in] height of the plane \param[in] is_line whether the nearest lie on a line */
  void
  add (double height, const LayerSurrounding& surrounding, bool is_line)
  {
    heights_.push_back (height);
    off_ += surrounding.is_off ? 1 : 0;
    if (surrounding.step > 0) {
      steps_.push_back ({height, surrounding.step});
      lines_ += is_line ? 1 : 0;
    }
  }

  /** The share of the points with others off their plane that see a layer next to theirs. */
  double
  shareStepped () const
  {
    return static_cast<double> (steps_.size ()) / off_;
  }

  /** \param[in] flat number of points in planes, parallel or not */
  bool
  areLayers (double flat)
  {
    const auto all = static_cast<double> (heights_.size ()), stepped = static_cast<double> (steps_.size ());
    if (all <= min_share_parallel * flat || off_ <= std::max (min_share_off * flat, min_count_off) ||
        stepped <= min_share_stepped * off_ || lines_ > max_share_lines * stepped)
      return false;
    std::sort (heights_.begin (), heights_.end ());
    const auto between = std::count_if (steps_.begin (), steps_.end (), [&] (const Step& step) {
      return hasPlane (step.height, step.size) && hasPlane (step.height, -step.size);
    });
    return static_cast<double> (between) > min_share_between * stepped;
  }

private:
  struct Step
  {
    double height, size;
  };

  /** Whether there is a plane about \a way off \a height. */
  bool
  hasPlane (double height, double way) const
  {
    const auto [low, high] = std::minmax ({height + .6 * way, height + 1.5 * way});
    const auto next = std::lower_bound (heights_.begin (), heights_.end (), low);
    return next != heights_.end () && *next < high;
  }

  std::vector<double> heights_;
  std::vector<Step> steps_;
  double off_ = 0, lines_ = 0;
};

class LayerFinder
{
public:
  explicit LayerFinder (const ThinnedSample& sample)
  : sample_ (sample), halvings_ (sample.size (), static_cast<float> (sample.levelCount ())), steps_ (sample.size (), 0)
  {}

  LayerEstimate
  find ()
  {
    bool have_layers = false;
    float spacing = 0;
    for (int halvings = 0; halvings < sample_.levelCount (); ++halvings) {
      const std::vector<Differences> differences = sample_.differencesAfter (halvings);
      const Planes planes = planesOf (differences);
      for (std::size_t s = 0; s < planes.size (); ++s)
        if (!planes[s])
          halvings_[s] = std::min (halvings_[s], static_cast<float> (halvings));
      have_layers |= showLayers (differences, planes);
      if (halvings == 0)
        spacing = medianReach (differences);
    }
    std::vector<LocalValue> steps = sample_.atPlaces (steps_);
    steps.erase (std::remove_if (steps.begin (), steps.end (), [] (const LocalValue& step) { return step.value == 0; }),
                 steps.end ());
    if (!have_layers || !(spacing > 0) || !areAlike (steps, spacing))
      return {};
    return {regionalMedians (sample_.atPlaces (halvings_), spacing), regionalMedians (steps, spacing),
            noiseOfStep (share_stepped_)};
  }

  /** Normals of planes, after find. */
  const std::vector<Eigen::Vector3d>&
  normals () const
  {
    return normals_;
  }

private:
  /** Whether this level of thinning shows layers. Records the steps of nodes that have none yet. */
  bool
  showLayers (const std::vector<Differences>& differences, const Planes& planes)
  {
    std::vector<Eigen::Vector3d> normals;
    for (const auto& plane : planes)
      if (plane)
        normals.push_back (*plane);
    const Eigen::Vector3d common = commonNormal (normals);
    ParallelPlanes parallel;
    for (std::size_t s = 0; s < planes.size (); ++s)
      if (planes[s] && areParallel (*planes[s], common)) {
        const LayerSurrounding surrounding = layerSurrounding (differences[s], common);
        parallel.add (sample_.place (s).dot (common), surrounding,
                      axesOfNearest (differences[s]).areLine (surely_line));
        if (steps_[s] == 0)
          steps_[s] = static_cast<float> (surrounding.step);
      }
    const auto flat = static_cast<double> (normals.size ());
    if (flat <= min_share_flat * static_cast<double> (planes.size ()) || !parallel.areLayers (flat))
      return false;
    if (share_stepped_ == 0)
      normals_ = normals;
    share_stepped_ = std::max (share_stepped_, parallel.shareStepped ());
    return true;
  }

  const ThinnedSample& sample_;
  std::vector<float> halvings_;          // until the nearest of a point of the sample are not in a plane
  std::vector<float> steps_;             // to the next layer, 0 if none is seen
  double share_stepped_ = 0;             // the largest ParallelPlanes::shareStepped of all levels that show layers
  std::vector<Eigen::Vector3d> normals_; // of the planes in the least thinned cloud that shows layers
};
} // namespace

LayerEstimate
estimateLayers (const NeighborGraph& graph, const Positions& nodes, const Execution& execution)
{
  const Execution still = execution.still ();
  if (!mayHaveLayers (graph, nodes, still))
    return {};
  const ThinnedSample sample (graph, nodes, still);
  LayerFinder finder (sample);
  LayerEstimate layers = finder.find ();
  layers.are_of_camera = layers.hasLayers () && areOfCamera (finder.normals (), graph, nodes, still);
  return layers;
}
} // namespace core
} // namespace pcl_normal_smoothing
