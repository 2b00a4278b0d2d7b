// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/smoothing.h>
#include <pcl_normal_smoothing/vector_layout.h>

#include <optional>

namespace pcl_normal_smoothing
{
/** As readNormals, of the nodes: where that of one is not finite or zero, that of its first copy that has one. */
core::Vectors
readNodeNormals (const VectorView& given, const core::NeighborGraph& graph, const core::Execution& execution);

/** Takes what was found of the nodes for their copies too: graph.points ().
  * \param[in] given the normals of the cloud, where they are not estimated: a copy may be the other side of the
  * surface, and a point whose own is not finite or zero does not move
  * \param[in,out] displacements, normals of the nodes; on return, of their copies too */
void
includeCopies (const core::NeighborGraph& graph,
               const std::optional<VectorView>& given,
               core::Vectors& displacements,
               core::Vectors& normals);

/** One smoothing of a cloud of any layout: what NormalSmoothing does for every kind of cloud. */
class SmoothingRun
{
public:
  /** \throw core::Error where an option or an index is out of range */
  SmoothingRun (const core::SmoothingOptions& options,
                const VectorView& positions,
                const pcl::Indices& indices,
                const core::Execution& execution);

  /** The positions of the whole cloud, before smooth. */
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

  /** With what was estimated from the cloud. */
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
  /** What belongs to these is written. */
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
  core::Elements with_copies_; // the points that are written, where they are more than the nodes
  core::Vectors displacements_;
  double unit_ = 1; // of the displacements
  core::Vectors normals_;
};
} // namespace pcl_normal_smoothing
