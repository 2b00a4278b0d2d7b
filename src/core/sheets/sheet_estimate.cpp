// SPDX-License-Identifier: BSD-3-Clause
#include "../quantile.h"
#include "sheet_normals.h"

#include "sheet_criterion.h"
#include "sheet_estimate.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
constexpr float min_share_beside = 0.1f;
constexpr double min_peak_over_valley = 1.5;
// Layers of a depth camera look like sheets, but: the points of one lie in a plane to within this share of the step;
// and the neighbours lie this much more to one side (median of SheetSample::sides).
constexpr float least_sigma_of_gap = .01f;
constexpr float side_of_layer = .6f;
// In a neighbourhood that is a ball inside wide noise, the points far off the plane lie more to one side than the
// points of any sheet.
constexpr float side_of_ball = .65f;

/** Directions, along the tangent plane, to a node's neighbours on other sheets: those above and those below. */
class OtherNeighbors
{
public:
  void
  add (const Eigen::Vector3f& way, float height, const Eigen::Vector3f& normal)
  {
    const Eigen::Vector3f along = way - way.dot (normal) * normal;
    sums_[height > 0] += along;
    lengths_ += along.norm ();
    ++count_;
  }

  int
  count () const
  {
    return count_;
  }

  /** See SheetSample::sides. */
  float
  side () const
  {
    return lengths_ > 0 ? (sums_[0].norm () + sums_[1].norm ()) / lengths_ : 0;
  }

private:
  std::array<Eigen::Vector3f, 2> sums_ {Eigen::Vector3f::Zero (), Eigen::Vector3f::Zero ()};
  float lengths_ = 0;
  int count_ = 0;
};

template <typename Condition>
std::vector<float>
filtered (const std::vector<float>& values, const Condition& condition)
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
  sides.insert (sides.end (), part.sides.begin (), part.sides.end ());
}

SheetSample
sampleSheets (const NeighborGraph& graph,
              const Positions& positions,
              const std::vector<std::uint32_t>& sample,
              const SheetScale& scale,
              const Execution& execution)
{
  const std::vector<std::uint32_t> around = nodesInRows (graph, sample, scale.row_length);
  const Vectors normals = electNormals (graph, positions, scale, &around, execution);
  const SheetCriterion criterion (positions, normals, scale.distance, false);
  SheetSample found;
  found.nodes = sample.size ();
  for (const std::uint32_t node : sample) {
    const Row row = graph.row (node);
    std::vector<float> heights;
    OtherNeighbors others;
    for (std::size_t j = 1; j < std::min (row.size (), scale.row_length); ++j)
      if (criterion.areParallel (node, row[j])) {
        const float height = criterion.height (node, row[j]);
        if (criterion.isOther (node, row[j], evidence_to_change))
          others.add (positions.difference (node, row[j]), height, normals[node]);
        heights.push_back (std::abs (height));
      }
    if (others.count () >= min_other_neighbors)
      found.join ({0, 1, heights, {others.side ()}});
  }
  return found;
}

SheetEstimate
estimateSheets (const SheetSample& sample, float distance)
{
  if (sample.nodes == 0)
    return {};
  const std::vector<float>& heights = sample.heights;
  const float share_beside = static_cast<float> (sample.nodes_beside) / static_cast<float> (sample.nodes);
  const SheetEstimate none {0, 0, share_beside};
  const std::vector<float> far = filtered (heights, [&] (float height) { return height > distance / 2; });
  if (share_beside < min_share_beside || far.empty ())
    return none;
  const float gap = quantile (far, .5);
  const auto countAt = [&] (float place) {
    return std::count_if (heights.begin (), heights.end (),
                          [&] (float height) { return std::abs (height - place) < 0.1f * gap; });
  };
  if (static_cast<double> (countAt (gap)) <= min_peak_over_valley * static_cast<double> (countAt (gap / 2)))
    return none;
  const std::vector<float> near = filtered (heights, [&] (float height) { return height < gap / 2; });
  // A height contains the noise of both points.
  const float sigma = quantile (near, .5) / (0.6745f * std::sqrt (2.0f));
  if (quantile (sample.sides, .5) > (sigma < least_sigma_of_gap * gap ? side_of_layer : side_of_ball))
    return none;
  return {gap, sigma, share_beside};
}
} // namespace core
} // namespace pcl_normal_smoothing
