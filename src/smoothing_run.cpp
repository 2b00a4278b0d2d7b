// SPDX-License-Identifier: BSD-3-Clause
#include "core/whole_cloud.h"
#include <pcl_normal_smoothing/smoothing_run.h>

#include <cmath>
#include <limits>
#include <utility>

namespace pcl_normal_smoothing
{
namespace
{
const Eigen::Vector3f not_a_normal = Eigen::Vector3f::Constant (std::numeric_limits<float>::quiet_NaN ());
} // namespace

core::Vectors
readNodeNormals (const VectorView& given, const core::NeighborGraph& graph, const core::Execution& execution)
{
  core::Vectors normals = readNormals (given, graph.order (), execution);
  const core::Vectors of_copies = readNormals (given, graph.copies ().points, execution);
  for (std::size_t i = 0; i < of_copies.size (); ++i)
    if (Eigen::Vector3f& normal = normals[graph.copies ().originals[i]]; std::isnan (normal.x ()))
      normal = of_copies[i];
  return normals;
}

void
includeCopies (const core::NeighborGraph& graph,
               const std::optional<VectorView>& given,
               core::Vectors& displacements,
               core::Vectors& normals)
{
  graph.repeatForCopies (displacements);
  graph.repeatForCopies (normals);
  if (!given || graph.copies ().points.empty ())
    return;
  const core::Vectors own = readNormals (*given, graph.points ());
  for (std::size_t i = 0; i < own.size (); ++i)
    if (std::isnan (own[i].x ())) {
      displacements[i].setZero ();
      normals[i] = not_a_normal;
    }
    else if (i >= graph.size () && normals[i].dot (own[i]) < 0)
      normals[i] *= -1;
}

SmoothingRun::SmoothingRun (const core::SmoothingOptions& options,
                            const VectorView& positions,
                            const pcl::Indices& indices,
                            const core::Execution& execution)
: options_ (options)
, execution_ (execution.silent ())
, selected_ (selectPoints (indices, positions.size))
, cloud_ (readPositions (positions, execution_))
{
  core::check (options);
}

void
SmoothingRun::smooth (const core::NeighborGraph::ConstPtr& graph,
                      const std::optional<VectorView>& normals,
                      const core::SearchAgain& search_again,
                      const core::Execution& execution)
{
  graph_ = graph;
  unit_ = cloud_.unit;
  core::MovingSurface surface (core::gather (cloud_, graph->order (), execution.silent ()));
  cloud_ = {}; // the nodes are a copy: keep the peak of memory low
  if (normals)
    surface.normals = readNodeNormals (*normals, *graph, execution_);
  core::SmoothingOptions options = options_.inUnit (unit_);
  core::prepareSmoothing (execution.still (), graph_, options, surface);
  core::smooth (graph_, options, search_again, execution, surface);
  options_ = options.inUnit (1 / unit_);
  displacements_ = surface.displacements ();
  normals_ = std::move (surface.normals);
  if (!graph_->copies ().points.empty ())
    with_copies_ = graph_->points ();
  includeCopies (*graph_, normals, displacements_, normals_);
}

void
SmoothingRun::writePositions (const VectorLayout& layout, std::uint8_t* data) const
{
  writeDisplacements (displacements_, unit_, points (), selected_, layout, data, execution_);
}

void
SmoothingRun::writeNormals (const VectorLayout& layout, std::uint8_t* data) const
{
  pcl_normal_smoothing::writeNormals (normals_, points (), selected_, layout, data, execution_);
}
} // namespace pcl_normal_smoothing
