// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sheet_estimate.h"

#include <array>

namespace pcl_normal_smoothing
{
namespace core
{
// Two points of one sheet are hardly farther apart across it, in sigmas.
constexpr float sheet_sigmas = 4;
// In spacings: the noise may be overestimated, because of the sheets themselves or because it varies.
constexpr float most_sheet_spacings = 1.2f;

/** Sheets are sought at three scales; the first that shows some decides. Sheets no farther apart than the points
  * need a small distance to be seen; in noise they show only in short rows. */
using SheetScales = std::array<SheetScale, 3>;

/** \param[in] sigma of the noise, as estimated; close sheets may make it too large
  * \param[in] spacing between neighbouring points */
SheetScales
sheetScales (float sigma, float spacing);

/** The sample of a cloud at each of the scales. */
using SheetSamples = std::array<SheetSample, std::tuple_size<SheetScales>::value>;

/** Whether a cloud has close sheets. */
struct SheetDetection
{
  /** At the first scale that shows sheets; gap 0 if none does. */
  SheetEstimate estimate;
  /** Sheets are seen, or may be hidden by the noise: more nodes have neighbours at another height than in a ball
    * inside the noise of one sheet. */
  bool may_exist = false;
};

/** \param[in] samples of one cloud, one for each of \a scales */
SheetDetection
decideSheets (const SheetSamples& samples, const SheetScales& scales);

/** As decideSheets, with samples taken from the graph.
  * \param[in] sample as for sampleSheets */
SheetDetection
detectSheets (const NeighborGraph& graph,
              const Positions& positions,
              const std::vector<std::uint32_t>& sample,
              const SheetScales& scales,
              const Execution& execution);
} // namespace core
} // namespace pcl_normal_smoothing
