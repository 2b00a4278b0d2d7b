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
  * Nodes are the cloud's finite points, or, if the query is for distinct points, the first in every place. Their
  * order follows space, so that a kernel that visits the nodes in order finds its neighbours in the cache, whatever
  * the cloud's order. A row begins with the point itself; its neighbours follow by (squared distance, index in the
  * cloud), and a tie at the k-th place goes to the lowest index. */
class NeighborGraph
{
public:
  using Ptr = std::shared_ptr<NeighborGraph>;
  using ConstPtr = std::shared_ptr<const NeighborGraph>;

  /** Replaces \a neighbors by the cloud indices of the neighbours of the point with the given index, in any order,
    * with or without the point itself. Called from many threads. */
  using Search = std::function<void (std::uint32_t index, std::vector<std::uint32_t>& neighbors)>;

  /** Searches the neighbours of all finite points.
    * \param[in] cloud positions in the cloud's order; those that are not finite are left out
    * \param[in] query k counts the point itself; if there are fewer than k points, rows contain all */
  static Ptr
  build (const Positions& cloud, const NeighborQuery& query, const Execution& execution);

  /** Searches the neighbours of some points only, and of those reachable from them: for a sample of a cloud.
    * \param[in] start finite points of the cloud, each once
    * \param[in] hops along rows. The nodes are \a start, in that order but without copies, and the points reached by
    * one more hop than this; the rows of those reached only by the last one hold just the node itself */
  static Ptr
  buildAround (const Positions& cloud,
               const Elements& start,
               int hops,
               const NeighborQuery& query,
               const Execution& execution);

  /** As build, with the results of any search.
    * \param[in] distinct as in NeighborQuery: a copy in the results stands for its node */
  static Ptr
  build (const Positions& cloud, const Search& search, const Execution& execution, bool distinct = false);

  /** The same nodes, with neighbourhoods searched again after they have moved.
    * \param[in] nodes positions in the order of the nodes */
  Ptr
  rebuild (const Positions& nodes, const NeighborQuery& query, const Execution& execution) const;

  /** As above, with the results of any search. */
  Ptr
  rebuild (const Positions& nodes, const Search& search, const Execution& execution) const;

  /** A graph with some rows replaced by others that are no longer; it shares the memory of all other blocks.
    * \param[in] nodes whose rows change, ascending
    * \param[in] rows of all \a nodes, one after another, each of the given \a length; the node itself comes first,
    * and pads the row after the last neighbour */
  Ptr
  withRows (const std::vector<std::uint32_t>& nodes, const std::vector<std::uint32_t>& rows, std::size_t length) const;

  /** Number of nodes. */
  std::size_t
  size () const
  {
    return order_->size ();
  }

  /** The neighbourhood of a node, as numbers of nodes. */
  Row
  row (std::size_t node) const;

  /** Nodes are grouped into blocks of block_size, for kernels that process several at once. */
  std::size_t
  blockCount () const
  {
    return (size () + block_size - 1) / block_size;
  }

  /** The neighbours of the nodes of a block: the first of every node, then the second of every node, and so on. A
    * shorter row is padded with its node; lanes beyond the last node repeat it. */
  const std::uint32_t*
  blockRows (std::size_t block) const
  {
    return block_rows_[block];
  }

  /** Begin of a block's rows when those of all blocks are stored one after another; for \a block = blockCount ()
    * their end. */
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

  /** Cloud index of every node. */
  const Elements&
  order () const
  {
    return *order_;
  }

  /** Points in the place of a node that are not nodes themselves; originals are nodes. */
  const Copies&
  copies () const
  {
    return *copies_;
  }

  /** Cloud index of every node, then of every copy. */
  Elements
  points () const;

  /** \param[in,out] of_nodes one value per node; on return one per element of points () */
  void
  repeatForCopies (Vectors& of_nodes) const;

  /** Number of points that are nodes or copies of nodes: for a whole cloud, all finite points. */
  std::size_t
  finiteCount () const
  {
    return order_->size () + copies_->points.size ();
  }

  /** Number of points of the cloud, including those that are not finite. */
  std::size_t
  cloudSize () const
  {
    return cloud_size_;
  }

private:
  class Rows;

  static constexpr auto no_node = std::numeric_limits<std::uint32_t>::max ();

  /** The node of every point that is a node or a copy of one; no_node for other points. */
  std::vector<std::uint32_t>
  nodesOfPoints () const;

  /** \param[in] copies with points as originals; those whose original is not a node are ignored */
  void
  setCopies (const Copies& copies);

  using Neighbors = PaddedVector<std::uint32_t>;

  std::shared_ptr<const Elements> order_ = std::make_shared<const Elements> (); // shared by graphs of the same nodes
  std::shared_ptr<const Copies> copies_ = std::make_shared<const Copies> ();    // likewise
  std::vector<std::shared_ptr<Neighbors>> neighbors_; // kept alive: that of all blocks, then those of changed rows
  std::vector<const std::uint32_t*> block_rows_;
  std::vector<std::size_t> block_begin_; // blockCount () + 1
  std::size_t cloud_size_ = 0, min_row_length_ = 0;
};

/** The elements of \a positions named by \a order, in that order. */
Positions
gather (const Positions& positions, const Elements& order, const Execution& execution = Execution (1));

/** The numbers of the positions with three finite coordinates. */
Elements
finiteElements (const Positions& positions, const Execution& execution = Execution (1));
} // namespace core
} // namespace pcl_normal_smoothing
