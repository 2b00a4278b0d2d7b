// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "proof.h"

#include <functional>

namespace pcl_normal_smoothing
{
namespace tools
{
/** How far a computation looks along the rows of neighbours. */
struct Depth
{
  /** It reads the rows of nodes that are up to so many hops away. Hops follow the neighbourhoods as used: those of one
    * sheet if sheets are separated. Below 0: it reads none. */
  int rows = 0;
  /** How many hops farther the searched rows are read to separate the sheets in such a row. Below 0: sheets are not
    * separated. */
  int separation = -1;
};

/** Some points of a plan, with all points around them on which a computation of a given depth depends. The rows of
  * neighbours that the computation reads are complete and in the right order: this is proven, and more points are
  * loaded until it can be. */
class Region
{
public:
  /** \param[in] plan, execution must outlive this object */
  Region (const Plan& plan, const core::NeighborQuery& query, const core::Execution& execution);

  /** Whether the computation is for a given point. */
  using IsWanted = std::function<bool (std::uint32_t cell, std::uint64_t number)>;

  /** Where wanted points of a cell lie: all of its points, or some. */
  struct Place
  {
    std::uint32_t cell;
    Eigen::AlignedBox3d box;
  };

  /** \param[in] places of the wanted points
    * \throw FileError if a file of points is damaged or missing */
  void
  load (const std::vector<Place>& places, const IsWanted& is_wanted, const Depth& depth);

  /** As load (), for all points of a tile. */
  void
  loadTile (std::size_t tile, const Depth& depth);

  std::size_t
  size () const
  {
    return cell_of_.size ();
  }

  /** A record of plan.record for every point, in the order of their numbers. */
  std::vector<std::uint8_t>&
  records ()
  {
    return records_;
  }

  /** In the unit of the plan, and in the order of the nodes. */
  core::Positions&
  nodes ()
  {
    return nodes_;
  }

  /** The normals of the files, in the order of the nodes; empty if they are not read. */
  core::Vectors&
  normals ()
  {
    return normals_;
  }

  /** The neighbourhoods, within one sheet if sheets are separated. The records are its cloud. */
  const core::NeighborGraph::ConstPtr&
  graph () const
  {
    return graph_;
  }

  /** For every record, whether the computation is for it. */
  const std::vector<bool>&
  wantedRecords () const
  {
    return wanted_records_;
  }

  /** The nodes of these records, and those of which they are copies; ascending. */
  const std::vector<std::uint32_t>&
  wanted () const
  {
    return wanted_;
  }

  /** How often neighbours were searched until all rows were proven complete. */
  std::uint64_t
  searches () const
  {
    return searches_;
  }

private:
  /** Loads what is likely to be needed. */
  void
  loadAround (const std::vector<Place>& places, int hops);

  /** \return whether there were any doubts */
  bool
  loadAround (std::vector<Doubt> doubts);

  /** Loads the cells that settle a doubt, and those at which the computation is likely to look from there. */
  void
  loadFor (const Doubt& doubt, const Neighborhoods& neighborhoods);

  void
  loadWithin (const Eigen::AlignedBox3d& box, double distance);

  void
  markLoaded (std::uint32_t cell);

  void
  readLoaded ();

  void
  search (const IsWanted& is_wanted, const Depth& depth);

  /** The nodes of the wanted records. */
  void
  findWanted ();

  Neighborhoods
  neighborhoods () const;

  const Plan& plan_;
  core::NeighborQuery query_;
  const core::Execution& execution_;
  CellIndex index_;
  std::vector<std::uint32_t> loaded_;
  std::vector<std::uint8_t> records_;
  std::vector<std::uint32_t> cell_of_; // of every record
  core::Positions nodes_;
  core::Vectors normals_;
  core::NeighborGraph::ConstPtr searched_, graph_;
  std::vector<bool> wanted_records_;
  std::vector<std::uint32_t> wanted_;
  std::uint64_t enough_ = 0; // so many points near a doubt should include all of its neighbours
  std::uint64_t searches_ = 0;
};
} // namespace tools
} // namespace pcl_normal_smoothing
