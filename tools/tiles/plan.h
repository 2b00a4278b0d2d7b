// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "files/point_stream.h"

#include <pcl_normal_smoothing/core/smoothing.h>
#include <pcl_normal_smoothing/vector_layout.h>

#include <cstring>
#include <string>
#include <vector>

namespace pcl_normal_smoothing
{
namespace tools
{
/** A file of points as `plan` found it. */
struct Source
{
  std::string path;
  CloudShape shape;
  /** Number of its first point among those of all files. */
  std::uint64_t first = 0;
  std::uint64_t bytes = 0;
  /** Time of the last change, in nanoseconds. */
  std::int64_t changed = 0;
  std::string checksum;
};

/** Points that are loaded together: some hundreds that lie close to each other. */
struct Cell
{
  /** Bounding box of its points, in the unit of the files. */
  Eigen::AlignedBox3d box;
  /** Of its records. */
  std::uint64_t checksum = 0;
  /** Where its records begin in the file of the tile. */
  std::uint64_t begin = 0;
  std::uint32_t points = 0;
  std::uint32_t tile = 0;
  /** How far a hop goes: from the point nearest the centre to the k-th nearest in the cell, but not beyond the radius
    * of the search; if it has fewer than k points or k is 0, that radius, or 0 if there is none. */
  float reach = 0;
  std::uint32_t padding = 0;
};

struct Tile
{
  std::uint64_t points = 0;
  std::uint32_t first_cell = 0;
  std::uint32_t cells = 0;
};

/** Layout of a point in the files of tiles: its number among those of all files, its position, and its normal if
  * normals are read or written; position and normal in floats or doubles. */
class RecordLayout
{
public:
  /** \param[in] positions, normals bytes per number; 0 = no normals */
  explicit RecordLayout (std::size_t positions = sizeof (float), std::size_t normals = 0)
  : positions_ (positions), normals_ (normals)
  {}

  std::size_t
  bytes () const
  {
    return sizeof (std::uint64_t) + 3 * (positions_ + normals_);
  }

  std::size_t
  positionBytes () const
  {
    return positions_;
  }

  std::size_t
  normalBytes () const
  {
    return normals_;
  }

  VectorLayout
  positions () const
  {
    return vectorAt (sizeof (std::uint64_t), positions_);
  }

  VectorLayout
  normals () const
  {
    return vectorAt (sizeof (std::uint64_t) + 3 * positions_, normals_);
  }

  static std::uint64_t
  numberOf (const std::uint8_t* record)
  {
    std::uint64_t number;
    std::memcpy (&number, record, sizeof number);
    return number;
  }

private:
  VectorLayout
  vectorAt (std::size_t begin, std::size_t size) const
  {
    return {bytes (),
            {begin, begin + size, begin + 2 * size},
            size == sizeof (float) ? VectorLayout::Scalar::FLOAT32 : VectorLayout::Scalar::FLOAT64};
  }

  std::size_t positions_;
  std::size_t normals_;
};

/** What `plan` leaves for `run` and `merge`: in a folder, as plan.json, cells.bin and one file of points per tile. */
struct Plan
{
  std::string folder;
  /** Distinguishes this plan from every other: results carry it. */
  std::string id;
  /** What was asked for: the options and the files. */
  std::string request;
  std::vector<Source> sources;
  /** Finite points of all files. */
  std::uint64_t points = 0;
  /** Layouts of the points in the files of tiles, and of results. */
  RecordLayout record, result;
  /** See core::Positions. */
  double unit = 1;
  /** In that unit, including what was estimated. */
  core::SmoothingOptions options;
  core::NeighborQuery query;
  /** Whether neighbours on other sheets are exchanged. */
  bool separate = false;
  bool save_normals = false;
  /** The parameters as options that reproduce the smoothing. */
  std::string parameters;
  std::vector<Tile> tiles;
  std::vector<Cell> cells;

  std::string
  pointsPath (std::size_t tile) const;

  std::string
  resultPath (std::size_t tile) const;

  /** Points of all files, including those that are not finite. */
  std::uint64_t
  cloudSize () const
  {
    return sources.empty () ? 0 : sources.back ().first + sources.back ().shape.size ();
  }
};

/** Writes cells.bin and, last of all, plan.json; sets the id. \throw FileError */
void
savePlan (Plan& plan);

/** \throw FileError if there is no complete plan */
Plan
loadPlan (const std::string& folder);

/** A cloud of that shape without its points: for code that looks for fields. */
CloudFile
emptyCloud (const CloudShape& shape);
} // namespace tools
} // namespace pcl_normal_smoothing
