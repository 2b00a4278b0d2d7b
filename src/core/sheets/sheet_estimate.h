// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** A scale at which sheets are sought. */
struct SheetScale
{
  /** A neighbour on another sheet is farther off than this. */
  float distance;
  /** Neighbours examined, the node included; the whole row if that is shorter. */
  std::size_t row_length;
};

/** Estimate of sheets hardly farther apart than the points, in the unit of the positions. */
struct SheetEstimate
{
  /** Distance between neighbouring sheets; 0 if none are seen. */
  float gap = 0;
  /** Standard deviation of the noise within a sheet, as for a Gaussian. */
  float sigma = 0;
  /** Share of the sample counted in SheetSample::nodes_beside. */
  float share_beside = 0;
};

/** What a sample shows of the sheets of a cloud. The samples of its parts, joined in any order, make that of the
  * whole. */
struct SheetSample
{
  std::size_t nodes = 0;
  /** Nodes with three neighbours on another sheet. */
  std::size_t nodes_beside = 0;
  /** Heights of their neighbours over the tangent planes. */
  std::vector<float> heights;
  /** How one-sided their neighbours on another sheet lie: from 0, all around, to 1, all in one direction. */
  std::vector<float> sides;

  void
  join (const SheetSample& part);
};

/** Number of places in the sample. */
constexpr std::size_t sheet_sample_size = 1024;

/** \param[in] sample nodes of the graph; the result depends on the rows of nodes up to sheet_sample_depth hops away */
SheetSample
sampleSheets (const NeighborGraph& graph,
              const Positions& positions,
              const std::vector<std::uint32_t>& sample,
              const SheetScale& scale,
              const Execution& execution);

/** Normals of neighbours are elected among those of their neighbours, which are estimated from the rows of these. */
constexpr int sheet_sample_depth = 2;

/** Sheets are seen if the heights have two peaks, that of the node's own sheet and that of another, with hardly any
  * points between them. Detail gives the tail of a single peak instead. Layers of coordinates in steps, as from depth
  * cameras, do not count either: where one ends the next begins, so that it lies to one side, not above.
  * \param[in] distance of the scale of the sample */
SheetEstimate
estimateSheets (const SheetSample& sample, float distance);
} // namespace core
} // namespace pcl_normal_smoothing
