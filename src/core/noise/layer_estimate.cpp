// SPDX-License-Identifier: BSD-3-Clause
#include "../quantile.h"
#include "camera_grid.h"
#include "layer_test.h"
#include "parallel_planes.h"
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
constexpr double surely_line = .2;
// Sigma in steps of noise that frays layers, on the large side: where it is .7, 1.2 leaves less than .8 does.
constexpr float noise_of_frayed_step = 1.2f;
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

class LayerFinder
{
public:
  explicit LayerFinder (const ThinnedSample& sample)
  : sample_ (sample)
  , halvings_ (sample.size (), static_cast<float> (sample.levelCount ()))
  , steps_ (sample.size (), 0)
  , frayed_steps_ (sample.size (), 0)
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
    are_frayed_ &= !have_layers;
    std::vector<LocalValue> steps = sample_.atPlaces (are_frayed_ ? frayed_steps_ : steps_);
    steps.erase (std::remove_if (steps.begin (), steps.end (), [] (const LocalValue& step) { return step.value == 0; }),
                 steps.end ());
    if (!(have_layers || are_frayed_) || !(spacing > 0) || !areAlike (steps, spacing))
      return {};
    return {regionalMedians (sample_.atPlaces (halvings_), spacing), regionalMedians (steps, spacing),
            are_frayed_ ? noise_of_frayed_step : noiseOfStep (share_stepped_)};
  }

  /** Whether what was found are layers only if a camera has seen them. */
  bool
  areFrayed () const
  {
    return are_frayed_;
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
        if (frayed_steps_[s] == 0)
          frayed_steps_[s] = static_cast<float> (surrounding.to_nearest_off);
      }
    const auto flat = static_cast<double> (normals.size ());
    if (flat <= min_share_flat * static_cast<double> (planes.size ()))
      return false;
    if (normals_.empty () && parallel.mayBeFrayedLayers (flat)) {
      are_frayed_ = true;
      normals_ = normals;
    }
    if (!parallel.areLayers (flat))
      return false;
    if (share_stepped_ == 0)
      normals_ = normals;
    share_stepped_ = std::max (share_stepped_, parallel.shareStepped ());
    return true;
  }

  const ThinnedSample& sample_;
  std::vector<float> halvings_;          // until the nearest of a point of the sample are not in a plane
  std::vector<float> steps_;             // to the next layer, 0 if none is seen
  std::vector<float> frayed_steps_;      // likewise, if layers have no edges
  bool are_frayed_ = false;              // at some level there may be frayed layers, and at none others
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
  return finder.areFrayed () && !layers.are_of_camera ? LayerEstimate () : layers;
}
} // namespace core
} // namespace pcl_normal_smoothing
