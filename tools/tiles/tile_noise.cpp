// SPDX-License-Identifier: BSD-3-Clause
#include "tile_noise.h"

#include "region.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <unordered_set>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
using Preparation = core::SmoothingPreparation;

/** Estimates the noise of all tiles by what it sees of each. */
class NoiseOfTiles
{
public:
  NoiseOfTiles (const Plan& plan, const std::vector<SamplePoint>& sample, const core::Execution& execution)
  : plan_ (plan), sample_ (sample), execution_ (execution)
  {}

  /** By neighbourhoods as they are searched. */
  core::NoiseEstimate
  mixed ()
  {
    return estimate (core::NeighborQuery {core::noise_row_length}, {0, -1});
  }

  /** By those of one sheet. */
  core::NoiseEstimate
  separated ()
  {
    static const core::Vectors none;
    return estimate (plan_.query, {0, core::separationDepth (Preparation::separation (plan_.options, none))});
  }

  /** \param[in] distance infinity: sheets are not looked for */
  core::SheetEstimate
  sheets (float distance)
  {
    if (std::isinf (distance))
      return {};
    core::SheetSample all;
    forEachTile (plan_.query, {core::sheet_sample_depth, -1}, [&] (Region& region) {
      std::vector<std::uint32_t> sample;
      const auto in_sample = core::sheetSampleNodes (region.nodes (), plan_.points, execution_);
      std::set_intersection (in_sample.begin (), in_sample.end (), region.wanted ().begin (), region.wanted ().end (),
                             std::back_inserter (sample));
      all.join (core::sampleSheets (*region.graph (), region.nodes (), sample, distance, execution_));
    });
    return core::estimateSheets (all, distance);
  }

private:
  core::NoiseEstimate
  estimate (const core::NeighborQuery& query, const Depth& depth)
  {
    core::NoiseSample all;
    forEachTile (query, depth, [&] (Region& region) {
      all.join (core::sampleNoise (*region.graph (), region.nodes (), region.wanted (), plan_.points, execution_));
    });
    return core::estimateNoise (all);
  }

  /** Calls \a body with the points of the sample in one tile after the other. */
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
      body (region);
      begin = end;
    }
  }

  std::uint32_t
  tileOf (std::size_t i) const
  {
    return plan_.cells[sample_[i].cell].tile;
  }

  const Plan& plan_;
  const std::vector<SamplePoint>& sample_;
  const core::Execution& execution_;
};
} // namespace

void
prepare (Plan& plan, const std::vector<SamplePoint>& sample, const core::Execution& execution)
{
  if (!plan.options.robust)
    return;
  const bool estimates = Preparation::needsNoise (plan.options);
  const bool estimates_sheets = plan.options.rounds.sheet_distance < 0 && !plan.options.rounds.oriented;
  NoiseOfTiles tiles (plan, sample, execution);
  core::NoiseEstimate noise;
  if (estimates)
    noise = tiles.mixed ();
  const core::SheetEstimate sheets = tiles.sheets (Preparation::sheetTestDistance (noise, plan.options));
  static const core::Vectors none;
  plan.separate = Preparation::setSheetDistance (noise, sheets, plan.options) &&
                  core::separationDepth (Preparation::separation (plan.options, none)) >= 0;
  if (plan.separate && estimates) {
    const core::NoiseEstimate separated = tiles.separated ();
    if (estimates_sheets && Preparation::areLayers (noise, separated, sheets)) {
      plan.separate = false;
      plan.options.rounds.sheet_distance = std::numeric_limits<float>::infinity ();
    }
    else
      noise = Preparation::chooseNoise (noise, separated, sheets);
  }
  Preparation::setNoise (noise, plan.options);
}
} // namespace tools
} // namespace pcl_normal_smoothing
