// SPDX-License-Identifier: BSD-3-Clause
#include "tile_noise.h"

#include "region.h"

#include <algorithm>
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
    return estimate (plan_.query, separationDepth ());
  }

  /** Whether a separated row anywhere is too short to tell of the noise. */
  bool
  anyRowIsShort ()
  {
    if (plan_.query.k > 0 && plan_.query.k < shortest ())
      return true;
    for (std::size_t tile = 0; tile < plan_.tiles.size (); ++tile) {
      Region region (plan_, plan_.query, execution_);
      region.loadTile (tile, separationDepth ());
      for (const std::uint32_t node : region.wanted ())
        if (region.graph ()->row (node).size () < shortest ())
          return true;
    }
    return false;
  }

private:
  std::uint64_t
  shortest () const
  {
    return std::min<std::uint64_t> (core::noise_row_length, plan_.points);
  }

  Depth
  separationDepth () const
  {
    static const core::Vectors none;
    return {0, core::separationDepth (Preparation::separation (plan_.options, none))};
  }

  core::NoiseEstimate
  estimate (const core::NeighborQuery& query, const Depth& depth)
  {
    core::NoiseSample all;
    for (std::size_t begin = 0; begin < sample_.size ();) { // of one tile after the other
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
      all.join (core::sampleNoise (*region.graph (), region.nodes (), region.wanted (), execution_));
      begin = end;
    }
    return core::estimateNoise (all);
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
  NoiseOfTiles tiles (plan, sample, execution);
  core::NoiseEstimate noise;
  if (estimates)
    noise = tiles.mixed ();
  static const core::Vectors none;
  plan.separate = Preparation::setSheetDistance (noise, plan.options) &&
                  core::separationDepth (Preparation::separation (plan.options, none)) >= 0;
  if (plan.separate && estimates && plan.options.rounds.noise.sigma < 0) {
    // Where a separated row is short, estimateNoise goes back to the neighbourhoods as they were searched. To be sure that none
    // is, all tiles have to be gone through; so that is done only where it could change something.
    const core::NoiseEstimate chosen = Preparation::chooseNoise (noise, tiles.separated ());
    if (chosen.sigma != noise.sigma && !tiles.anyRowIsShort ())
      noise = chosen;
  }
  Preparation::setNoise (noise, plan.options);
}
} // namespace tools
} // namespace pcl_normal_smoothing
