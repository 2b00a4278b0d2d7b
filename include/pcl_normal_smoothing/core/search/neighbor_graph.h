// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/block_size.h>
#include <pcl_normal_smoothing/core/search/distinct_points.h>
#include <pcl_normal_smoothing/core/search/neighbor.h>

#include <memory>

namespace pcl_normal_smoothing
{
namespace core
{
/** The neighbourhoods of all finite points of a cloud, searched once and shared by all stages.
  *
  * Its nodes are the cloud's finite points, or, where the query is for distinct ones, the first in every place of
  * these, in an order that follows space, so that a kernel that walks over the nodes finds its neighbours in the cache
  * whatever the cloud's order. A row begins with the point itself; its neighbours follow by (squared distance, index in
  * the cloud), and a tie at the k-th place goes to the lowest index. */
class NeighborGraph
{
public:
  using Ptr = std::shared_ptr<NeighborGraph>;
  using ConstPtr = std::shared_ptr<const NeighborGraph>;

  /** Replaces \a neighbors by the indices in the cloud of the neighbours of the point with that index, in any order,
    * with or without the point itself. Called from many threads. */
  using Search = std::function<void (std::uint32_t index, std::vector<std::uint32_t>& neighbors)>;

  /** Searches the neighbours of all finite points.
    * \param[in] cloud positions in the cloud's order; those that are not finite are left out
    * \param[in] query k counts the point itself; fewer points than k: the rows hold all there are */
  static Ptr
  build (const Positions& cloud, const NeighborQuery& query, const Execution& execution);

  /** Searches the neighbours of some points only, and of what can be reached from them: for a sample of a cloud.
    * \param[in] start finite points of the cloud, each once
    * \param[in] hops along rows. The nodes are \a start, in that order, copies apart, and what is reached by so many
    * hops and one more; the rows of what only the last one reaches hold nothing but the node */
  static Ptr
  buildAround (const Positions& cloud,
               const Elements& start,
               int hops,
               const NeighborQuery& query,
               const Execution& execution);

  /** As build, from the answers of any search.
    * \param[in] distinct as in NeighborQuery: what the search says of a copy, it says of the node */
  static Ptr
  build (const Positions& cloud, const Search& search, const Execution& execution, bool distinct = false);

  /** The same nodes, with neighbourhoods searched anew after they have moved.
    * \param[in] nodes positions in the order of the nodes */
  Ptr
  rebuild (const Positions& nodes, const NeighborQuery& query, const Execution& execution) const;

  /** As above, from the answers of any search. */
  Ptr
  rebuild (const Positions& nodes, const Search& search, const Execution& execution) const;

  /** A graph in which some rows are others, no longer than they were; it shares the memory of all other blocks.
    * \param[in] nodes whose rows change, ascending
    * \param[in] rows those of all \a nodes, one after the other, of \a length each; the node itself comes first and
    * fills what is left behind the last neighbour */
  Ptr
  withRows (const std::vector<std::uint32_t>& nodes, const std::vector<std::uint32_t>& rows, std::size_t length) const;

  /** Number of nodes. */
  std::size_t
  size () const
  {
    return order_->size ();
  }

  /** The neighbourhood of a node: numbers of nodes. */
  Row
  row (std::size_t node) const;

  /** Nodes come in blocks of block_size, for kernels that work on several at once. */
  std::size_t
  blockCount () const
  {
    return (size () + block_size - 1) / block_size;
  }

  /** The neighbours of the nodes of a block: the first of every node, then the second of every node ... A node with
    * fewer than the others is its own neighbour for the rest; lanes behind the last node repeat it. */
  const std::uint32_t*
  blockRows (std::size_t block) const
  {
    return block_rows_[block];
  }

  /** Where the rows of a block begin among those of all blocks, one after the other; for \a block = blockCount () their
    * end. */
  std::size_t
  blockBegin (std::size_t block) const
  {
    return block_begin_[block];
  }

  /** Length of the longest row of a block. */
  std::size_t
  blockLength (std::size_t block) const
  {
    return (block_begin_[block + 1] - block_begin_[block]) / block_size;
  }

  /** Length of the shortest row; 0 without nodes. */
  std::size_t
  minRowLength () const
  {
    return min_row_length_;
  }

  /** Index in the cloud of every node. */
  const Elements&
  order () const
  {
    return *order_;
  }

  /** Points that lie where a node lies, and are none themselves; originals are nodes. */
  const Copies&
  copies () const
  {
    return *copies_;
  }

  /** Index in the cloud of every node, then of every copy. */
  Elements
  points () const;

  /** \param[in,out] of_nodes what belongs to the nodes; on return, to points () */
  void
  repeatForCopies (Vectors& of_nodes) const;

  /** Number of points that are nodes or copies of them: of a whole cloud, all that are finite. */
  std::size_t
  finiteCount () const
  {
    return order_->size () + copies_->points.size ();
  }

  /** Number of points of the cloud, those that are not finite included. */
  std::size_t
  cloudSize () const
  {
    return cloud_size_;
  }

private:
  class Rows;

  static constexpr auto no_node = std::numeric_limits<std::uint32_t>::max ();

  /** The node of every point that is one, or a copy of one; of others no_node. */
  std::vector<std::uint32_t>
  nodesOfPoints () const;

  /** \param[in] copies with points as originals; those that are no nodes do not count */
  void
  setCopies (const Copies& copies);

  using Neighbors = PaddedVector<std::uint32_t>;

  std::shared_ptr<const Elements> order_ = std::make_shared<const Elements> (); // shared by graphs of the same nodes
  std::shared_ptr<const Copies> copies_ = std::make_shared<const Copies> ();    // likewise
  std::vector<std::shared_ptr<Neighbors>> neighbors_; // kept alive: those of all blocks, then changed ones
  std::vector<const std::uint32_t*> block_rows_;
  std::vector<std::size_t> block_begin_; // blockCount () + 1
  std::size_t cloud_size_ = 0, min_row_length_ = 0;
};

/** The elements of \a positions that \a order names, in that order. */
Positions
gather (const Positions& positions, const Elements& order, const Execution& execution = Execution (1));

/** Numbers of the positions whose three coordinates are finite. */
Elements
finiteElements (const Positions& positions, const Execution& execution = Execution (1));
} // namespace core
} // namespace pcl_normal_smoothing
