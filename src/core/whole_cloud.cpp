// SPDX-License-Identifier: BSD-3-Clause
#include "whole_cloud.h"
#include "noise/noise_of_sample.h"
#include "search/hash_sample.h"
#include "smoothing_preparation.h"

#include <algorithm>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
// Sheets nearer than this many steps are layers of a wall that faces a depth camera.
constexpr float sheet_steps = 1.5f;

/** Raises the noise where neighbourhoods grow because of it. */
NoiseField
largerWhereWide (NoiseField field, const WideNoise& wide)
{
  for (RegionalField::Region& region : field.factors.regions)
    if (wide.halvings.valueAt (region.centre, 0) >= .5f) // from this value on neighbourhoods grow
      region.value *= wide.excess;
  return field;
}

/** A cloud processed as a whole. */
class WholeCloud : public SmoothingPreparation
{
public:
  /** \param[in,out] surface kept while this is used, like all arguments */
  WholeCloud (MovingSurface& surface, const Execution& execution, NeighborGraph::ConstPtr& graph)
  : positions_ (surface.positions)
  , normals_ (surface.normals)
  , execution_ (execution)
  , graph_ (graph)
  , unseparated_ (graph)
  {}

  /** \param[in] may_project false if the normals are given: points without one may not move, and opposite normals
    * separate sheets
    * \return whether neighbourhoods had to grow, or points to be projected */
  bool
  widen (bool may_project)
  {
    widening_ = estimateWidening (*unseparated_, positions_, execution_);
    if (!may_project)
      widening_.wide_noise.ratios = {};
    if (const auto wide = widenNeighborhoods (*unseparated_, positions_, widening_, execution_))
      graph_ = unseparated_ = wide;
    else if (const auto projected = projectNodes (*unseparated_, widening_, execution_, positions_))
      graph_ = unseparated_ = projected;
    else
      widening_ = widening_.roundingAlone ();
    return widening_.isNeeded ();
  }

  NoiseHiddenBy
  noiseHiddenBy () const
  {
    return widening_.hiddenBy ();
  }

  /** See LayerEstimate::are_of_camera. */
  bool
  isOfCamera () const
  {
    return widening_.layers.are_of_camera;
  }

protected:
  NoiseEstimate
  noiseBeforeSeparation () override
  {
    return noiseOf (sampleNoise (*graph_, positions_, execution_));
  }

  SheetDetection
  sheets (const SheetScales& scales) override
  {
    const std::vector<std::uint32_t> sample = sampleNodes (positions_, sheet_sample_size, execution_);
    const SheetDetection detected = detectSheets (*graph_, positions_, sample, scales, execution_);
    return detected.estimate.gap < sheet_steps * largestStep () ? SheetDetection () : detected;
  }

  bool
  separate (const SmoothingOptions& options) override
  {
    const SheetSeparationOptions by = separation (options, normals_);
    if (separationDepth (by) < 0)
      return false;
    graph_ = separateSheets (unseparated_, positions_, by, execution_);
    return graph_ != unseparated_ || unseparated_->minRowLength () < noise_row_length;
  }

  NoiseEstimate
  separatedNoise () override
  {
    const std::size_t size = graph_->finiteCount ();
    const std::vector<std::uint32_t> sample = sampleNodes (positions_, noise_sample_size, execution_);
    return noiseOf (sampleNoise (*graph_, positions_, sample, size, execution_));
  }

  void
  undoSeparation () override
  {
    graph_ = unseparated_;
  }

  bool
  underestimatesWideNoise () const override
  {
    return !widening_.isNeeded () && !(widening_.rounding.step > 0);
  }

  bool
  reachOverGaps () const override
  {
    return widening_.lines.hasLines ();
  }

private:
  NoiseEstimate
  noiseOf (const NoiseSample& sample) const
  {
    NoiseEstimate noise = noiseOfSample (sample, widening_);
    const WideNoise& wide = widening_.wide_noise;
    if (!wide.is_everywhere)
      noise.field = largerWhereWide (noise.field, wide);
    else if (wide.sigma > 0 && !widening_.projects ())
      noise.sigma *= wide.excess;
    return noise;
  }

  /** The largest step between layers or of rounded coordinates; 0 if there are none. */
  float
  largestStep () const
  {
    const std::vector<float> steps = widening_.layers.steps.values ();
    return std::max (widening_.rounding.step, steps.empty () ? 0 : *std::max_element (steps.begin (), steps.end ()));
  }

  Positions& positions_;
  const Vectors& normals_;
  const Execution& execution_;
  NeighborGraph::ConstPtr& graph_;
  NeighborGraph::ConstPtr unseparated_; // the graph before sheets were separated
  Widening widening_;                   // that of unseparated_
};
} // namespace

void
prepareSmoothing (const Execution& execution,
                  NeighborGraph::ConstPtr& graph,
                  SmoothingOptions& options,
                  MovingSurface& surface)
{
  WholeCloud cloud (surface, execution, graph);
  const bool moves = options.in_rounds && options.rounds.count > 0 && options.rounds.noise.sigma != 0;
  const bool may_project = options.normals != NormalSource::INPUT;
  options.widen_neighborhoods = moves && options.widen_neighborhoods && cloud.widen (may_project);
  options.rounds.along_rays = cloud.isOfCamera ();
  cloud.complete (options);
  options.rounds.noise.hidden_by = cloud.noiseHiddenBy ();
}
} // namespace core
} // namespace pcl_normal_smoothing
