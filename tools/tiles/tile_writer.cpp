// SPDX-License-Identifier: BSD-3-Clause
#include "tile_writer.h"

#include "files/checksum.h"

#include <core/search/hash_sample.h>
#include <core/search/select_nth.h>

#include <algorithm>
#include <cmath>

namespace pcl_normal_smoothing
{
namespace tools
{
TileWriter::TileWriter (Plan& plan,
                        std::uint64_t max_points,
                        std::size_t cell_points,
                        std::uint32_t sample_limit,
                        const core::Execution& execution)
: plan_ (plan)
, max_points_ (max_points)
, cell_points_ (cell_points)
, sample_limit_ (sample_limit)
, execution_ (execution)
{}

void
TileWriter::add (const std::vector<std::uint8_t>& records)
{
  const VectorView view {plan_.record.positions (), records.data (), records.size () / plan_.record.bytes ()};
  if (view.size == 0)
    return;
  points_.resize (view.size);
  core::parallelFor (view.size, execution_, [&] (std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      points_[i] = {view.layout.get (view.data, i), static_cast<std::uint32_t> (i)};
  });
  in_sample_.assign (view.size, false);
  for (const std::uint32_t i :
       core::nodesUpTo (sample_limit_, readPositions (view, plan_.unit, execution_), execution_))
    in_sample_[i] = true;
  std::vector<Range> tiles;
  split ({0, view.size}, max_points_, tiles);
  for (const Range& tile : tiles)
    writeTile (records, tile);
}

void
TileWriter::split (Range range, std::size_t most, std::vector<Range>& parts)
{
  if (range.end - range.begin <= most)
    return parts.push_back (range);
  const auto at = [&] (std::size_t i) { return points_.begin () + static_cast<std::ptrdiff_t> (i); };
  Eigen::AlignedBox3d box;
  std::for_each (at (range.begin), at (range.end), [&] (const Point& point) { box.extend (point.place); });
  int axis = 0;
  box.sizes ().maxCoeff (&axis);
  const std::size_t middle = range.begin + (range.end - range.begin) / 2;
  // Points at one place may end up in different parts: whatever touches one of them loads all of these.
  Point* const points = points_.data ();
  core::selectNth (points + range.begin, points + middle, points + range.end,
                   [axis] (const Point& point) { return point.place[axis]; });
  split ({range.begin, middle}, most, parts);
  split ({middle, range.end}, most, parts);
}

std::vector<std::pair<TileWriter::Range, Cell>>
TileWriter::makeCells (Range range)
{
  constexpr std::size_t side_by_side = 16;
  std::vector<Range> parts;
  split (range, std::max (cell_points_, (range.end - range.begin) / side_by_side + 1), parts);
  std::vector<std::vector<std::pair<Range, Cell>>> cells (parts.size ());
  core::parallelFor (
      parts.size (), execution_,
      [&] (std::size_t begin, std::size_t end) {
        for (std::size_t part = begin; part < end; ++part) {
          std::vector<Range> ranges;
          split (parts[part], cell_points_, ranges);
          for (const Range& cell : ranges)
            cells[part].emplace_back (cell, makeCell (cell));
        }
      },
      1);
  for (std::size_t part = 1; part < cells.size (); ++part)
    cells.front ().insert (cells.front ().end (), cells[part].begin (), cells[part].end ());
  return cells.front ();
}

void
TileWriter::writeTile (const std::vector<std::uint8_t>& records, Range range)
{
  Tile tile {range.end - range.begin, static_cast<std::uint32_t> (plan_.cells.size ()), 0};
  const std::string path = plan_.pointsPath (plan_.tiles.size ());
  OutputFile file (path);
  const std::size_t step = plan_.record.bytes ();
  std::uint64_t written = 0;
  std::string bytes;
  for (auto& [cell_range, cell] : makeCells (range)) {
    bytes.clear ();
    for (std::size_t i = cell_range.begin; i < cell_range.end; ++i) {
      const std::uint8_t* record = &records[points_[i].record * step];
      bytes.append (reinterpret_cast<const char*> (record), step);
      if (in_sample_[points_[i].record])
        sample_.push_back (
            {static_cast<std::uint32_t> (plan_.cells.size ()), RecordLayout::numberOf (record), points_[i].place});
    }
    cell.checksum = checksumOf (bytes);
    cell.begin = written;
    cell.tile = static_cast<std::uint32_t> (plan_.tiles.size ());
    plan_.cells.push_back (cell);
    file.write (bytes);
    written += bytes.size ();
  }
  tile.cells = static_cast<std::uint32_t> (plan_.cells.size ()) - tile.first_cell;
  plan_.tiles.push_back (tile);
  removeOnInterruption (path);
  file.commit ();
}

Cell
TileWriter::makeCell (Range range)
{
  Cell cell;
  const auto begin = points_.begin () + static_cast<std::ptrdiff_t> (range.begin),
             end = points_.begin () + static_cast<std::ptrdiff_t> (range.end);
  std::sort (begin, end, [] (const Point& a, const Point& b) { return a.record < b.record; });
  std::for_each (begin, end, [&] (const Point& point) { cell.box.extend (point.place); });
  cell.points = static_cast<std::uint32_t> (range.end - range.begin);
  cell.reach = reachOf (range, cell.box.center ());
  return cell;
}

float
TileWriter::reachOf (Range range, const Eigen::Vector3d& center) const
{
  const core::NeighborQuery& query = plan_.query;
  const auto radius = static_cast<float> (plan_.unit * static_cast<double> (query.radius));
  if (query.k == 0 || range.end - range.begin < query.k)
    return std::isfinite (radius) ? radius : 0;
  std::vector<double> distances;
  const auto begin = points_.begin () + static_cast<std::ptrdiff_t> (range.begin),
             end = points_.begin () + static_cast<std::ptrdiff_t> (range.end);
  const auto middle = std::min_element (begin, end, [&] (const Point& a, const Point& b) {
    return (a.place - center).squaredNorm () < (b.place - center).squaredNorm ();
  });
  for (auto point = begin; point != end; ++point)
    distances.push_back ((point->place - middle->place).norm ());
  const auto farthest = distances.begin () + static_cast<std::ptrdiff_t> (query.k - 1);
  std::nth_element (distances.begin (), farthest, distances.end ());
  return std::min (static_cast<float> (*farthest), radius);
}
} // namespace tools
} // namespace pcl_normal_smoothing
