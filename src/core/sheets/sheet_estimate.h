// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** At which scale sheets are looked for. */
struct SheetScale
{
  /** That a neighbour on another sheet exceeds. */
  float distance;
  /** Neighbours that are asked, the node counted, or the whole row where that is shorter. */
  std::size_t row_length;
};

/** What a cloud tells of sheets that are hardly farther apart than its points, in the unit of its positions. */
struct SheetEstimate
{
  /** Distance from one sheet to the next; 0 where none is seen. */
  float gap = 0;
  /** Standard deviation of the noise by the points of a sheet, as of a Gaussian. */
  float sigma = 0;
  /** Of the sample: see SheetSample::nodes_beside. */
  float share_beside = 0;
};

/** What the sample of a cloud tells of its sheets. The samples of its parts make that of the whole, in any order. */
struct SheetSample
{
  std::size_t nodes = 0;
  /** Those that have three neighbours on another sheet. */
  std::size_t nodes_beside = 0;
  /** How far the neighbours of those lie from the tangent planes. */
  std::vector<float> heights;
  /** How much on one side of those their neighbours on another sheet lie, from 0, all around, to 1, in one
    * direction. */
  std::vector<float> sides;

  void
  join (const SheetSample& part);
};

/** Places of which the sample is. */
constexpr std::size_t sheet_sample_size = 1024;

/** \param[in] sample nodes of the graph; what it tells depends on the rows of nodes up to sheet_sample_depth hops
  * off */
SheetSample
sampleSheets (const NeighborGraph& graph,
              const Positions& positions,
              const std::vector<std::uint32_t>& sample,
              const SheetScale& scale,
              const Execution& execution);

/** The normals of the neighbours are elected among those of theirs, which are estimated from their rows. */
constexpr int sheet_sample_depth = 2;

/** Sheets are seen where the heights have two peaks, that of a node's own sheet and that of another one, and hardly any
  * points between. The tail of one peak, as detail has it, is none; nor are the layers of coordinates in steps, as
  * depth cameras give them: where one ends the next begins, and lies beside it, not above.
  * \param[in] distance of the sample */
SheetEstimate
estimateSheets (const SheetSample& sample, float distance);
} // namespace core
} // namespace pcl_normal_smoothing
