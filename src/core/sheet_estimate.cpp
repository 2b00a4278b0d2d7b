// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/noise_sample.h>
#include <pcl_normal_smoothing/core/quantile.h>
#include <pcl_normal_smoothing/core/sheet_estimate.h>
#include <pcl_normal_smoothing/core/sheet_normals.h>
#include <pcl_normal_smoothing/core/sheet_test.h>

#include <algorithm>
#include <cmath>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
constexpr std::size_t sample_size = 1024;
constexpr double min_share_beside = 0.1;
constexpr double min_peak_over_valley = 1.5;

template <typename Condition>
std::vector<float>
those (const std::vector<float>& values, const Condition& condition)
{
  std::vector<float> found;
  std::copy_if (values.begin (), values.end (), std::back_inserter (found), condition);
  return found;
}
} // namespace

void
SheetSample::join (const SheetSample& part)
{
  nodes += part.nodes;
  nodes_beside += part.nodes_beside;
  heights.insert (heights.end (), part.heights.begin (), part.heights.end ());
}

std::vector<std::uint32_t>
sheetSampleNodes (const Positions& nodes, std::uint64_t cloud_size, const Execution& execution)
{
  return sampleNodes (nodes, cloud_size, sample_size, execution);
}

SheetSample
sampleSheets (const NeighborGraph& graph,
              const Positions& positions,
              const std::vector<std::uint32_t>& sample,
              float distance,
              const Execution& execution)
{
  const std::vector<std::uint32_t> around = nodesInRows (graph, sample, sheet_row_length);
  const Vectors normals = electNormals (graph, positions, distance, &around, execution);
  const SheetTest test (positions, normals, distance, false);
  SheetSample found;
  found.nodes = sample.size ();
  for (const std::uint32_t node : sample) {
    const Row row = graph.row (node);
    std::vector<float> heights;
    int others = 0;
    for (std::size_t j = 1; j < std::min (row.size (), sheet_row_length); ++j)
      if (test.areParallel (node, row[j])) {
        others += test.isOther (node, row[j], evidence_to_change);
        heights.push_back (std::abs (test.height (node, row[j])));
      }
    if (others >= min_other_neighbors)
      found.join ({0, 1, heights});
  }
  return found;
}

SheetEstimate
estimateSheets (SheetSample sample, float distance)
{
  const std::vector<float>& heights = sample.heights;
  const std::vector<float> far = those (heights, [&] (float height) { return height > distance / 2; });
  if (static_cast<double> (sample.nodes_beside) < min_share_beside * static_cast<double> (sample.nodes) || far.empty ())
    return {};
  const float gap = quantile (far, .5);
  const auto countAt = [&] (float place) {
    return std::count_if (heights.begin (), heights.end (),
                          [&] (float height) { return std::abs (height - place) < 0.1f * gap; });
  };
  if (static_cast<double> (countAt (gap)) <= min_peak_over_valley * static_cast<double> (countAt (gap / 2)))
    return {};
  const std::vector<float> near = those (heights, [&] (float height) { return height < gap / 2; });
  // Both points of a pair have noise.
  return {gap, quantile (near, .5) / (0.6745f * std::sqrt (2.0f))};
}

SheetEstimate
estimateSheets (const NeighborGraph& graph, const Positions& positions, float distance, const Execution& execution)
{
  if (std::isinf (distance))
    return {};
  const std::vector<std::uint32_t> sample = sheetSampleNodes (positions, positions.size (), execution);
  return estimateSheets (sampleSheets (graph, positions, sample, distance, execution), distance);
}
} // namespace core
} // namespace pcl_normal_smoothing
