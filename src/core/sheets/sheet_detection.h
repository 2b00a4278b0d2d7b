// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sheet_estimate.h"

#include <array>

namespace pcl_normal_smoothing
{
namespace core
{
/** Sheets are looked for at one scale after the other: what is seen first counts. Those no farther apart than the
  * points are hidden where only what lies well apart counts, and noise hides among many neighbours what few of them
  * show. */
using SheetScales = std::array<SheetScale, 3>;

/** \param[in] sigma of the noise, as it seems: for the sheets' sake it may seem large
  * \param[in] spacing between neighbouring points */
SheetScales
sheetScales (float sigma, float spacing);

/** What the sample of a cloud tells, at each of the scales. */
using SheetSamples = std::array<SheetSample, std::tuple_size<SheetScales>::value>;

/** Whether a cloud has close sheets. */
struct SheetDetection
{
  /** At the first scale that shows any; of a gap of 0 where none does. */
  SheetEstimate estimate;
  /** Sheets are seen, or lost in the noise: more nodes see others at another height than in a ball inside the noise
    * of one sheet. */
  bool may_exist = false;
};

/** \param[in] samples of one cloud, sampled at these scales */
SheetDetection
decideSheets (const SheetSamples& samples, const SheetScales& scales);

/** The same by a sample of the graph.
  * \param[in] sample as for sampleSheets */
SheetDetection
detectSheets (const NeighborGraph& graph,
              const Positions& positions,
              const std::vector<std::uint32_t>& sample,
              const SheetScales& scales,
              const Execution& execution);
} // namespace core
} // namespace pcl_normal_smoothing
