// SPDX-License-Identifier: BSD-3-Clause
#include "region.h"

#include "record_file.h"

#include <core/smoothing_preparation.h>
#include <pcl_normal_smoothing/smoothing_run.h>

#include <algorithm>
#include <cmath>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
// A factor, as walks follow the longer hops.
constexpr double hop_lengths = 1.2;
// Points are few if they are fewer than one in so many of those loaded.
constexpr std::size_t few_of = 500;

double
farthest (const Eigen::Vector3d& place, const Eigen::AlignedBox3d& box)
{
  return (place - box.min ()).cwiseAbs ().cwiseMax ((place - box.max ()).cwiseAbs ()).norm ();
}

/** How far a hop goes near a cell: by the median reach of cells around it. */
double
hopLength (const std::vector<Cell>& cells, std::size_t cell)
{
  std::vector<float> reaches;
  for (std::size_t i = cell < 2 ? 0 : cell - 2; i < std::min (cell + 3, cells.size ()); ++i)
    reaches.push_back (cells[i].reach);
  std::nth_element (reaches.begin (), reaches.begin () + static_cast<std::ptrdiff_t> (reaches.size () / 2),
                    reaches.end ());
  return hop_lengths * static_cast<double> (reaches[reaches.size () / 2]);
}

/** Sorts parts in parallel, then merges them. */
template <typename Item, typename Less>
void
sortInParts (std::vector<Item>& items, const core::Execution& execution, const Less& less)
{
  constexpr std::size_t part_size = 1 << 18;
  const auto at = [&] (std::size_t i) {
    return items.begin () + static_cast<std::ptrdiff_t> (std::min (i, items.size ()));
  };
  core::parallelFor (
      items.size (), execution, [&] (std::size_t begin, std::size_t end) { std::sort (at (begin), at (end), less); },
      part_size);
  for (std::size_t size = part_size; size < items.size (); size *= 2)
    core::parallelFor (
        items.size (), execution,
        [&] (std::size_t begin, std::size_t end) {
          std::inplace_merge (at (begin), at (begin + size), at (end), less);
        },
        2 * size);
}
} // namespace

Region::Region (const Plan& plan, const core::NeighborQuery& query, const core::Execution& execution)
: plan_ (plan), query_ (query), execution_ (execution), index_ (plan.cells)
{}

void
Region::load (const std::vector<Place>& places, const IsWanted& is_wanted, const Depth& depth)
{
  for (const Place& place : places)
    markLoaded (place.cell);
  loadAround (places, depth.rows + 1 + std::max (depth.separation, 0));
  enough_ = query_.k;
  bool proven = false;
  while (!proven) {
    graph_ = searched_ = nullptr;
    readLoaded ();
    search (is_wanted, depth);
    proven = !loadAround (findDoubts (neighborhoods (), wanted_, depth, execution_));
    enough_ *= 2; // many points may be copies of others
  }
}

void
Region::loadTile (std::size_t tile, const Depth& depth)
{
  const Tile& cells = plan_.tiles[tile];
  std::vector<Place> places;
  for (std::uint32_t cell = cells.first_cell; cell < cells.first_cell + cells.cells; ++cell)
    places.push_back ({cell, plan_.cells[cell].box});
  load (
      places, [&] (std::uint32_t cell, std::uint64_t) { return plan_.cells[cell].tile == tile; }, depth);
}

Neighborhoods
Region::neighborhoods () const
{
  return {plan_, query_, *searched_, *graph_, nodes_, cell_of_, index_};
}

void
Region::markLoaded (std::uint32_t cell)
{
  if (index_.isLoaded (cell))
    return;
  index_.setLoaded (cell);
  loaded_.push_back (cell);
}

void
Region::loadWithin (const Eigen::AlignedBox3d& box, double distance)
{
  std::vector<std::uint32_t> found;
  index_.forEachNear (box, distance, [&] (std::uint32_t cell, double) { found.push_back (cell); });
  for (const std::uint32_t cell : found)
    markLoaded (cell);
}

void
Region::loadAround (const std::vector<Place>& places, int hops)
{
  for (const Place& place : places)
    loadWithin (place.box, hops * hopLength (plan_.cells, place.cell));
}

bool
Region::loadAround (std::vector<Doubt> doubts)
{
  std::sort (doubts.begin (), doubts.end (), [] (const Doubt& a, const Doubt& b) {
    return a.hops_left > b.hops_left || (a.hops_left == b.hops_left && a.node < b.node);
  });
  const Neighborhoods current = neighborhoods ();
  for (const Doubt& doubt : doubts)
    loadFor (doubt, current);
  return !doubts.empty ();
}

void
Region::loadFor (const Doubt& doubt, const Neighborhoods& neighborhoods)
{
  struct Found
  {
    double farthest, nearest;
    std::uint32_t cell;
  };
  const Eigen::Vector3d place = neighborhoods.placeOf (doubt.node);
  const Eigen::AlignedBox3d box (place);
  std::vector<Found> found;
  double radius = neighborhoods.rowRadius (doubt.node);
  index_.forEachNear (box, radius, [&] (std::uint32_t cell, double distance) {
    found.push_back ({farthest (place, plan_.cells[cell].box), distance, cell});
  });
  // Once the closest cells hold enough points, points beyond these cells cannot be among the k nearest.
  std::sort (found.begin (), found.end (), [] (const Found& a, const Found& b) { return a.farthest < b.farthest; });
  std::uint64_t points = 0;
  for (const Found& cell : found) {
    points += plan_.cells[cell.cell].points;
    if (query_.k > 0 && points >= enough_) {
      radius = std::min (radius, cell.farthest);
      break;
    }
  }
  for (const Found& cell : found)
    if (cell.nearest <= radius) {
      const double reach = plan_.cells[cell.cell].reach > 0 ? hopLength (plan_.cells, cell.cell) : radius;
      markLoaded (cell.cell);
      loadWithin (plan_.cells[cell.cell].box, doubt.hops_left * reach);
    }
}

void
Region::readLoaded ()
{
  struct Key
  {
    std::uint64_t number;
    std::uint32_t cell;
    std::uint32_t at;
  };
  std::sort (loaded_.begin (), loaded_.end ());
  const std::size_t step = plan_.record.bytes ();
  records_.clear ();
  std::vector<Key> keys;
  std::uint64_t points = 0;
  for (const std::uint32_t cell : loaded_)
    points += plan_.cells[cell].points;
  records_.reserve (points * step);
  keys.reserve (points);
  RecordReader reader (plan_);
  for (const std::uint32_t cell : loaded_) {
    reader.read (cell, records_);
    for (std::size_t at = keys.size (); at < records_.size () / step; ++at)
      keys.push_back ({RecordLayout::numberOf (&records_[at * step]), cell, static_cast<std::uint32_t> (at)});
  }
  // Neighbours at equal distances are ordered by number.
  sortInParts (keys, execution_.silent (), [] (const Key& a, const Key& b) { return a.number < b.number; });
  std::vector<std::uint8_t> sorted (records_.size ());
  cell_of_.resize (keys.size ());
  core::parallelFor (keys.size (), execution_.silent (), [&] (std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      std::copy_n (&records_[keys[i].at * step], step, &sorted[i * step]);
      cell_of_[i] = keys[i].cell;
    }
  });
  records_.swap (sorted);
}

void
Region::search (const IsWanted& is_wanted, const Depth& depth)
{
  ++searches_;
  const RecordLayout& record = plan_.record;
  const core::Positions positions =
      readPositions (VectorView {record.positions (), records_.data (), size ()}, plan_.unit, execution_);
  wanted_records_.assign (size (), false);
  core::Elements points;
  for (const std::uint32_t i : core::finiteElements (positions, execution_))
    if (is_wanted (cell_of_[i], RecordLayout::numberOf (&records_[i * record.bytes ()]))) {
      wanted_records_[i] = true;
      points.push_back (i);
    }
  // Searching point by point takes a few times as long per point, but if few points are wanted, it skips most of what
  // is loaded.
  const bool are_few = depth.rows == 0 && points.size () < size () / few_of;
  searched_ =
      are_few ? core::NeighborGraph::buildAround (positions, points, std::max (depth.separation, 0), query_, execution_)
              : core::NeighborGraph::build (positions, query_, execution_);
  nodes_ = core::gather (positions, searched_->order (), execution_);
  if (record.normalBytes () > 0)
    normals_ = readNodeNormals ({record.normals (), records_.data (), size ()}, *searched_, execution_);
  graph_ = searched_;
  if (depth.separation >= 0)
    graph_ = core::separateSheets (searched_, nodes_, core::SmoothingPreparation::separation (plan_.options, normals_),
                                   execution_);
  findWanted ();
}

void
Region::findWanted ()
{
  wanted_.clear ();
  for (std::uint32_t node = 0; node < searched_->size (); ++node)
    if (wanted_records_[searched_->order ()[node]])
      wanted_.push_back (node);
  const core::Copies& copies = searched_->copies ();
  for (std::size_t i = 0; i < copies.points.size (); ++i)
    if (wanted_records_[copies.points[i]])
      wanted_.push_back (copies.originals[i]);
  std::sort (wanted_.begin (), wanted_.end ());
  wanted_.erase (std::unique (wanted_.begin (), wanted_.end ()), wanted_.end ());
}
} // namespace tools
} // namespace pcl_normal_smoothing
