// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <vector>

namespace pcl_normal_smoothing
{
namespace core
{
/** Receives the rows of a graph, in any order and from any thread. */
class NeighborGraph::Rows
{
public:
  /** \param[in] length of every row; 0: they differ */
  Rows (NeighborGraph& graph, std::size_t length) : graph_ (graph), length_ (length)
  {
    if (length == 0)
      rows_.resize (graph_.size ());
    else
      setLengths (std::vector<std::size_t> (graph_.blockCount (), length));
  }

  /** \param[in] node_of the node of every slot in \a row; null: slots are nodes */
  void
  put (std::uint32_t node, const std::vector<Neighbor>& row, const std::uint32_t* node_of = nullptr)
  {
    const auto nodeOf = [&] (const Neighbor& neighbor) {
      return node_of == nullptr ? neighbor.slot : node_of[neighbor.slot];
    };
    if (length_ == 0)
      std::transform (row.begin (), row.end (), std::back_inserter (rows_[node]), nodeOf);
    else {
      std::uint32_t* out = begin (node);
      *out = node;
      for (const Neighbor& neighbor : row)
        *(out += block_size) = nodeOf (neighbor);
    }
  }

  void
  finish ()
  {
    if (length_ == 0)
      copyRows ();
    graph_.min_row_length_ = minLength ();
    const std::size_t size = graph_.size ();
    for (std::size_t lane = size; lane < graph_.blockCount () * block_size; ++lane)
      for (std::size_t j = 0; j < graph_.blockLength (lane / block_size); ++j)
        begin (lane)[j * block_size] = begin (size - 1)[j * block_size];
  }

private:
  std::uint32_t*
  begin (std::size_t node)
  {
    return graph_.neighbors_[0]->data () + graph_.block_begin_[node / block_size] + node % block_size;
  }

  void
  setLengths (const std::vector<std::size_t>& lengths)
  {
    graph_.block_begin_.assign (1, 0);
    for (const std::size_t length : lengths)
      graph_.block_begin_.push_back (graph_.block_begin_.back () + length * block_size);
    graph_.neighbors_ = {std::make_shared<Neighbors> (graph_.block_begin_.back ())};
    for (std::size_t block = 0; block < lengths.size (); ++block)
      graph_.block_rows_.push_back (graph_.neighbors_[0]->data () + graph_.block_begin_[block]);
  }

  std::size_t
  minLength () const
  {
    std::size_t length = length_ == 0 && !rows_.empty () ? rows_[0].size () + 1 : length_;
    for (const auto& row : rows_)
      length = std::min (length, row.size () + 1);
    return length;
  }

  void
  copyRows ()
  {
    std::vector<std::size_t> lengths (graph_.blockCount (), 1);
    for (std::size_t node = 0; node < rows_.size (); ++node)
      lengths[node / block_size] = std::max (lengths[node / block_size], rows_[node].size () + 1);
    setLengths (lengths);
    for (std::size_t node = 0; node < rows_.size (); ++node)
      for (std::size_t j = 0; j < lengths[node / block_size]; ++j)
        begin (node)[j * block_size] =
            j == 0 || j > rows_[node].size () ? static_cast<std::uint32_t> (node) : rows_[node][j - 1];
  }

  NeighborGraph& graph_;
  std::size_t length_;
  std::vector<std::vector<std::uint32_t>> rows_; // if lengths differ; without the node itself
};
} // namespace core
} // namespace pcl_normal_smoothing
