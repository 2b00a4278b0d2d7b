// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/smoothing.h>
#include <pcl_normal_smoothing/vector_layout.h>

#include <optional>

namespace pcl_normal_smoothing
{
/** readNormals for the nodes; if a node's normal is not finite or zero, that of its first copy with a valid one. */
core::Vectors
readNodeNormals (const VectorView& given, const core::NeighborGraph& graph, const core::Execution& execution);

/** Extends the results of nodes to their copies: to graph.points ().
  * \param[in] given the normals of the cloud, if they are not estimated: a copy may be on the other side of the
  * surface, and a point whose own normal is not finite or zero does not move
  * \param[in,out] displacements, normals of the nodes; on return, of their copies too */
void
includeCopies (const core::NeighborGraph& graph,
               const std::optional<VectorView>& given,
               core::Vectors& displacements,
               core::Vectors& normals);

/** One smoothing of a cloud of any layout: the work of NormalSmoothing for every kind of cloud. */
class SmoothingRun
{
public:
  /** \throw core::Error if an option or an index is out of range */
  SmoothingRun (const core::SmoothingOptions& options,
                const VectorView& positions,
                const pcl::Indices& indices,
                const core::Execution& execution);

  /** The positions of the whole cloud, before a call of smooth. */
  const core::Positions&
  cloud () const
  {
    return cloud_;
  }

  /** \param[in] normals of the cloud, for NormalSource::INPUT
    * \param[in] search_again see core::updatePoints */
  void
  smooth (const core::NeighborGraph::ConstPtr& graph,
          const std::optional<VectorView>& normals,
          const core::SearchAgain& search_again,
          const core::Execution& execution);

  /** The options, including those estimated from the cloud. */
  const core::SmoothingOptions&
  options () const
  {
    return options_;
  }

  /** Moves the indexed points of the cloud at \a data. */
  void
  writePositions (const VectorLayout& layout, std::uint8_t* data) const;

  /** Writes the normals of the indexed points to the cloud at \a data. */
  void
  writeNormals (const VectorLayout& layout, std::uint8_t* data) const;

private:
  /** The points whose results are written. */
  const core::Elements&
  points () const
  {
    return with_copies_.empty () ? graph_->order () : with_copies_;
  }

  core::SmoothingOptions options_;
  core::Execution execution_; // silent
  std::vector<bool> selected_;
  core::Positions cloud_;
  core::NeighborGraph::ConstPtr graph_;
  core::Elements with_copies_; // the points that are written, if they are more than the nodes
  core::Vectors displacements_;
  double unit_ = 1; // of the displacements
  core::Vectors normals_;
};
} // namespace pcl_normal_smoothing
