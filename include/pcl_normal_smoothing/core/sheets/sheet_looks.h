// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/sheets/sheet_estimate.h>

#include <array>

namespace pcl_normal_smoothing
{
namespace core
{
/** Sheets are looked for in several ways, one after the other: what is seen first counts. Those no farther apart than the points are hidden from
  * a look that tells apart what lies well apart, and noise hides from a look at many neighbours what a look at few of them shows. */
using SheetLooks = std::array<SheetLook, 3>;

/** \param[in] sigma of the noise, as it seems: for the sheets' sake it may seem large
  * \param[in] spacing between neighbouring points */
SheetLooks
sheetLooks (float sigma, float spacing);

/** What the sample of a cloud tells, by each of the looks. */
using SheetSamples = std::array<SheetSample, std::tuple_size<SheetLooks>::value>;

/** What is seen of sheets. */
struct SheetSight
{
  /** By the first look that shows any; of a gap of 0 where none does. */
  SheetEstimate sheets;
  /** Sheets are seen, or lost in the noise: more nodes see others at another height than in a ball inside the noise of one sheet. */
  bool may_be = false;
};

SheetSight
seenSheets (const SheetSamples& samples, const SheetLooks& looks);

/** The same by a sample of the graph.
  * \param[in] sample as for sampleSheets */
SheetSight
lookForSheets (const NeighborGraph& graph,
               const Positions& positions,
               const std::vector<std::uint32_t>& sample,
               const SheetLooks& looks,
               const Execution& execution);
} // namespace core
} // namespace pcl_normal_smoothing
