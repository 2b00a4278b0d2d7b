// SPDX-License-Identifier: BSD-3-Clause
#include "tile_run.h"

#include "region.h"
#include "tile_result.h"

#include <core/smoothing_preparation.h>
#include <pcl_normal_smoothing/smoothing_run.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
class TileSmoothing
{
public:
  TileSmoothing (const Plan& plan, std::size_t tile, unsigned threads)
  : plan_ (plan), tile_ (tile), execution_ (threads), region_ (plan, plan.query, execution_)
  {}

  TileRun
  run ()
  {
    load ();
    smooth ();
    write ();
    const std::uint64_t points = plan_.tiles[tile_].points;
    return {points, region_.size () - points, region_.searches ()};
  }

private:
  void
  load ()
  {
    Depth depth {core::smoothingDepth (plan_.options) - 1, -1};
    if (plan_.separate)
      depth.separation =
          core::separationDepth (core::SmoothingPreparation::separation (plan_.options, region_.normals ()));
    region_.loadTile (tile_, depth);
  }

  void
  smooth ()
  {
    core::MovingSurface surface (std::move (region_.nodes ()), std::move (region_.normals ()));
    core::estimateFirstNormals (*region_.graph (), plan_.options, execution_, surface);
    const auto has_normal = [&] (std::uint32_t node) { return !std::isnan (surface.normals[node].x ()); };
    with_normal_ =
        static_cast<std::uint64_t> (std::count_if (region_.wanted ().begin (), region_.wanted ().end (), has_normal));
    core::smoothByNormals (region_.graph (), plan_.options, {}, execution_, surface);
    displacements_ = surface.displacements ();
    normals_ = std::move (surface.normals);
    std::optional<VectorView> given;
    if (plan_.options.normals == NormalSource::INPUT)
      given = VectorView {plan_.record.normals (), region_.records ().data (), region_.size ()};
    includeCopies (*region_.graph (), given, displacements_, normals_);
  }

  void
  write ()
  {
    std::vector<std::uint8_t>& records = region_.records ();
    const std::vector<bool>& selected = region_.wantedRecords ();
    const core::Elements points = region_.graph ()->points ();
    writeDisplacements (displacements_, plan_.unit, points, selected, plan_.record.positions (), records.data ());
    std::vector<std::size_t> place_of (region_.size ()); // index in points
    for (std::size_t place = 0; place < points.size (); ++place)
      place_of[points[place]] = place;

    const std::size_t from = plan_.record.bytes (), to = plan_.result.bytes ();
    std::vector<std::uint8_t> result;
    result.reserve (plan_.tiles[tile_].points * to);
    for (std::size_t i = 0; i < region_.size (); ++i) {
      if (!selected[i])
        continue;
      result.resize (result.size () + to);
      std::uint8_t* record = &result[result.size () - to];
      std::copy_n (&records[i * from], sizeof (std::uint64_t) + 3 * plan_.result.positionBytes (), record);
      if (plan_.save_normals)
        plan_.result.normals ().set (record, 0, normals_[place_of[i]].cast<double> ());
    }
    saveResult (plan_, tile_, result, with_normal_);
  }

  const Plan& plan_;
  std::size_t tile_;
  core::Execution execution_;
  Region region_;
  core::Vectors displacements_, normals_; // one per element of region_.graph ()->points ()
  std::uint64_t with_normal_ = 0;
};
} // namespace

TileRun
runTile (const Plan& plan, std::size_t tile, unsigned threads)
{
  return TileSmoothing (plan, tile, threads).run ();
}
} // namespace tools
} // namespace pcl_normal_smoothing
