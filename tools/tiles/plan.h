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
/** A file of points as `plan` has seen it. */
struct Source
{
  std::string path;
  CloudShape shape;
  /** Number of its first point among those of all files. */
  std::uint64_t first = 0;
  std::uint64_t bytes = 0;
  /** When it was last changed, in nanoseconds. */
  std::int64_t changed = 0;
  std::string checksum;
};

/** Points that are loaded together: some hundreds near each other. */
struct Cell
{
  /** Of its points, in the unit of the files. */
  Eigen::AlignedBox3d box;
  /** Of its records. */
  std::uint64_t checksum = 0;
  /** Where its records begin in the file of the tile. */
  std::uint64_t begin = 0;
  std::uint32_t points = 0;
  std::uint32_t tile = 0;
  /** From the point in its middle to the farthest of the k nearest: how far a hop goes; 0 where it has fewer than k. */
  float reach = 0;
  std::uint32_t padding = 0;
};

struct Tile
{
  std::uint64_t points = 0;
  std::uint32_t first_cell = 0;
  std::uint32_t cells = 0;
};

/** What a point is in the files of tiles: its number among those of all files, its position, and a normal where that is
  * read or written, each of floats or doubles. */
class RecordLayout
{
public:
  /** \param[in] normals bytes of their numbers; 0 = none */
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

/** What `plan` leaves for `run` and `merge`: in a folder, as plan.json, cells.bin and a file of points for every
  * tile. */
struct Plan
{
  std::string folder;
  /** Tells this plan from every other: results carry it. */
  std::string id;
  /** What was asked for: the options and the files. */
  std::string request;
  std::vector<Source> sources;
  /** Finite points of all files. */
  std::uint64_t points = 0;
  /** Of the points in the files of tiles, and of results. */
  RecordLayout record, result;
  /** See core::Positions. */
  double unit = 1;
  /** In that unit, with all that was estimated. */
  core::SmoothingOptions options;
  core::NeighborQuery query;
  /** Neighbours on other sheets are exchanged. */
  bool separate = false;
  bool save_normals = false;
  /** As options that give the same smoothing again. */
  std::string parameters;
  std::vector<Tile> tiles;
  std::vector<Cell> cells;

  std::string
  pointsPath (std::size_t tile) const;

  std::string
  resultPath (std::size_t tile) const;

  /** Points of all files, those that are not finite included. */
  std::uint64_t
  cloudSize () const
  {
    return sources.empty () ? 0 : sources.back ().first + sources.back ().shape.size ();
  }
};

/** Writes cells.bin and, last of all, plan.json; sets the id. \throw FileError */
void
savePlan (Plan& plan);

/** \throw FileError where there is no complete plan */
Plan
loadPlan (const std::string& folder);

/** The cloud of a shape, without its points: for code that looks for fields. */
CloudFile
emptyCloud (const CloudShape& shape);
} // namespace tools
} // namespace pcl_normal_smoothing
