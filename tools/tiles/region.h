// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "proof.h"

#include <functional>

namespace pcl_normal_smoothing
{
namespace tools
{
/** How far along the rows of neighbours something looks. */
struct Depth
{
  /** Rows of nodes that are up to so many hops off are read, over neighbourhoods as they are used: those of one sheet
    * where sheets are separated. Below 0: none is. */
  int rows = 0;
  /** Sheets are separated: to write such a row, rows as they were searched are read so many hops farther. Below 0: they
    * are not. */
  int separation = -1;
};

/** Some points of a plan with all around them on which a computation of that depth depends. In the rows of neighbours
  * that the computation reads, and in their order, nothing is missing: that is proven, and more loaded until it can
  * be. */
class Region
{
public:
  /** \param[in] plan, execution used as long as this lives */
  Region (const Plan& plan, const core::NeighborQuery& query, const core::Execution& execution);

  /** Whether a point is one of those that the computation is for. */
  using IsWanted = std::function<bool (std::uint32_t cell, std::uint64_t number)>;

  /** Where wanted points lie: all those of a cell, or some. */
  struct Place
  {
    std::uint32_t cell;
    Eigen::AlignedBox3d box;
  };

  /** \param[in] places of the wanted points
    * \throw FileError where a file of points is damaged or missing */
  void
  load (const std::vector<Place>& places, const IsWanted& is_wanted, const Depth& depth);

  /** The same for all points of a tile. */
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

  /** The normals of the files, in the order of the nodes; empty where they are not read. */
  core::Vectors&
  normals ()
  {
    return normals_;
  }

  /** The neighbourhoods, of one sheet where they are separated. Its cloud are the records. */
  const core::NeighborGraph::ConstPtr&
  graph () const
  {
    return graph_;
  }

  /** The records that the computation is for. */
  const std::vector<bool>&
  wantedRecords () const
  {
    return wanted_records_;
  }

  /** Their nodes, and those of which they are copies; ascending. */
  const std::vector<std::uint32_t>&
  wanted () const
  {
    return wanted_;
  }

  /** How often neighbours were searched until all rows were proven. */
  std::uint64_t
  searches () const
  {
    return searches_;
  }

private:
  /** A guess. */
  void
  loadAround (const std::vector<Place>& places, int hops);

  /** \return whether there was something to load */
  bool
  loadAround (std::vector<Doubt> doubts);

  /** The cells that settle a doubt, and those that the computation is likely to look at from there. */
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
  std::uint64_t enough_ = 0; // points near a doubt, for all of its neighbours to be among them
  std::uint64_t searches_ = 0;
};
} // namespace tools
} // namespace pcl_normal_smoothing
