// SPDX-License-Identifier: BSD-3-Clause
#include "sheet_detection.h"
#include "sheet_criterion.h"

#include <algorithm>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
// Like most_sheet_spacings, for sheets closer than usual.
constexpr float closer_spacings = .65f;
// Share of the sample beside another sheet, at the first scale: .1 to .46 in a ball inside the noise of one sheet, .6
// to .97 for sheets that the noise hides.
constexpr float most_beside_in_ball = .55f;
} // namespace

SheetScales
sheetScales (float sigma, float spacing)
{
  const float of_noise = sheet_sigmas * sigma;
  const float usual = std::min (of_noise, most_sheet_spacings * spacing), closer = closer_spacings * spacing;
  return {{{usual, sheet_row_length}, {usual, short_row_length}, {closer, short_row_length}}};
}

SheetDetection
decideSheets (const SheetSamples& samples, const SheetScales& scales)
{
  const SheetEstimate first = estimateSheets (samples[0], scales[0].distance);
  SheetEstimate estimate = first;
  for (std::size_t i = 1; i < scales.size () && !(estimate.gap > 0); ++i)
    estimate = estimateSheets (samples[i], scales[i].distance);
  return {estimate, estimate.gap > 0 || first.share_beside > most_beside_in_ball};
}

SheetDetection
detectSheets (const NeighborGraph& graph,
              const Positions& positions,
              const std::vector<std::uint32_t>& sample,
              const SheetScales& scales,
              const Execution& execution)
{
  std::size_t longest = 0;
  for (std::size_t block = 0; block < graph.blockCount (); ++block)
    longest = std::max (longest, graph.blockLength (block));
  const auto show_the_same = [longest] (const SheetScale& a, const SheetScale& b) {
    return a.distance == b.distance && std::min (a.row_length, longest) == std::min (b.row_length, longest);
  };
  SheetSamples samples;
  for (std::size_t i = 0; i < scales.size (); ++i)
    samples[i] = i > 0 && show_the_same (scales[i], scales[i - 1])
                     ? samples[i - 1]
                     : sampleSheets (graph, positions, sample, scales[i], execution);
  return decideSheets (samples, scales);
}
} // namespace core
} // namespace pcl_normal_smoothing
