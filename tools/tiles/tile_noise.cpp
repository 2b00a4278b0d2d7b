// SPDX-License-Identifier: BSD-3-Clause
#include "tile_noise.h"

#include "command_line/tool.h"
#include "region.h"

#include <core/noise/noise_of_sample.h>
#include <core/search/hash_sample.h>
#include <core/smoothing_preparation.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <unordered_set>
#include <utility>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
constexpr double share_of_planes = .1;
constexpr double share_of_spacing = .2;     // from here on a step of the coordinates is noise
constexpr float ratio_of_wide_noise = .36f; // sigma to spacing; core/noise/wide_noise.h looks at thinned clouds, too

/** A cloud that is read in tiles. */
class TiledCloud : public core::SmoothingPreparation
{
public:
  /** \param[in,out] plan must, like all arguments, outlive this object */
  TiledCloud (Plan& plan,
              const std::vector<SamplePoint>& sample,
              std::uint32_t sheet_limit,
              const core::Execution& execution)
  : plan_ (plan), sample_ (sample), sheet_limit_ (sheet_limit), execution_ (execution)
  {}

  /** Whether many points lie in planes exactly, the coordinates are rounded, or the noise is wide. Known after
    * complete (). */
  bool
  mayNeedWidening () const
  {
    return may_need_widening_;
  }

protected:
  core::NoiseEstimate
  noiseBeforeSeparation () override
  {
    core::NeighborQuery query {core::noise_row_length};
    query.distinct = plan_.query.distinct;
    core::NoiseSample sample = sampleOf (query, {0, -1});
    const core::NoiseEstimate noise = core::noiseOfSample (sample);
    const auto all = static_cast<double> (sample.of_nodes.size ());
    std::vector<Eigen::Vector3d> places;
    for (const core::NoiseSample::Residuals& residuals : sample.of_nodes)
      places.push_back (residuals.place.cast<double> ());
    may_need_widening_ = core::coordinateStep (places) > share_of_spacing * noise.spacing ||
                         noise.sigma * noise.field.largestFactor () > ratio_of_wide_noise * noise.spacing ||
                         static_cast<double> (sample.dropPlanes ()) > share_of_planes * all;
    return noise;
  }

  core::SheetDetection
  sheets (const core::SheetScales& scales) override
  {
    core::SheetSamples all;
    forEachTile (plan_.query, {core::sheet_sample_depth, -1}, [&] (Region& region, const Nodes& wanted) {
      Nodes sample;
      const auto in_sample = core::nodesUpTo (sheet_limit_, region.nodes (), execution_);
      std::set_intersection (in_sample.begin (), in_sample.end (), wanted.begin (), wanted.end (),
                             std::back_inserter (sample));
      for (std::size_t i = 0; i < scales.size (); ++i)
        all[i].join (core::sampleSheets (*region.graph (), region.nodes (), sample, scales[i], execution_));
    });
    return core::decideSheets (all, scales);
  }

  bool
  separate (const core::SmoothingOptions& options) override
  {
    static const core::Vectors none;
    separation_depth_ = core::separationDepth (separation (options, none));
    return plan_.separate = separation_depth_ >= 0;
  }

  core::NoiseEstimate
  separatedNoise () override
  {
    return core::noiseOfSample (sampleOf (plan_.query, {0, separation_depth_}));
  }

  void
  undoSeparation () override
  {
    plan_.separate = false;
  }

private:
  using Nodes = std::vector<std::uint32_t>;

  core::NoiseSample
  sampleOf (const core::NeighborQuery& query, const Depth& depth)
  {
    core::NoiseSample all;
    forEachTile (query, depth, [&] (Region& region, const Nodes& wanted) {
      all.join (core::sampleNoise (*region.graph (), region.nodes (), wanted, plan_.points, execution_));
    });
    return all;
  }

  /** The wanted nodes, less those of which only a copy is wanted: these count in their own tile. */
  static Nodes
  withoutCopies (const Region& region)
  {
    Nodes nodes;
    std::copy_if (region.wanted ().begin (), region.wanted ().end (), std::back_inserter (nodes),
                  [&] (std::uint32_t node) { return region.wantedRecords ()[region.graph ()->order ()[node]]; });
    return nodes;
  }

  /** Calls \a body, tile by tile, with the points of the sample. */
  template <typename Body>
  void
  forEachTile (const core::NeighborQuery& query, const Depth& depth, const Body& body)
  {
    for (std::size_t begin = 0; begin < sample_.size ();) {
      std::size_t end = begin;
      std::vector<Region::Place> places;
      std::unordered_set<std::uint64_t> numbers;
      for (; end < sample_.size () && tileOf (end) == tileOf (begin); ++end) {
        places.push_back ({sample_[end].cell, Eigen::AlignedBox3d (sample_[end].place)});
        numbers.insert (sample_[end].number);
      }
      Region region (plan_, query, execution_);
      region.load (
          places, [&] (std::uint32_t, std::uint64_t number) { return numbers.count (number) > 0; }, depth);
      body (region, withoutCopies (region));
      begin = end;
    }
  }

  std::uint32_t
  tileOf (std::size_t i) const
  {
    return plan_.cells[sample_[i].cell].tile;
  }

  Plan& plan_;
  const std::vector<SamplePoint>& sample_;
  std::uint32_t sheet_limit_;
  const core::Execution& execution_;
  int separation_depth_ = -1;
  bool may_need_widening_ = false;
};
} // namespace

void
completeOptions (Plan& plan,
                 const std::vector<SamplePoint>& sample,
                 std::uint32_t sheet_limit,
                 const core::Execution& execution)
{
  TiledCloud cloud (plan, sample, sheet_limit, execution);
  cloud.complete (plan.options);
  // With wider neighbourhoods, one tile might need all of the cloud.
  const bool widens = std::exchange (plan.options.widen_neighborhoods, false) && plan.options.in_rounds;
  if (widens && cloud.mayNeedWidening ())
    note ("neighbourhoods may be too narrow to show the surface, for many points lie in planes with those around them, "
          "exactly (on the lines of a lidar, or in the steps of a depth camera), the coordinates are rounded, or the "
          "noise is wide: pcl_normal_smoothing might widen them; the tiles will be as with its -widen_neighborhoods 0");
}
} // namespace tools
} // namespace pcl_normal_smoothing
