// SPDX-License-Identifier: BSD-3-Clause
#include "local_residuals.h"

#include "../quantile.h"
#include "../spacing.h"
#include "noise_reach.h"
#include "residual_quantiles.h"

#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

#include <cmath>
#include <limits>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
constexpr float median_of_16 = .934f; // of chi-square with 10 degrees of freedom, over these

std::vector<std::vector<std::uint32_t>>
neighborsInSample (const NoiseSample& sample, std::uint32_t count, const Execution& execution)
{
  Positions places;
  for (const NoiseSample::Residuals& residuals : sample.of_nodes)
    places.base.push_back (residuals.place);
  places.offset.assign (places.base.size (), Eigen::Vector3f::Zero ());
  const auto graph = NeighborGraph::build (places, {count}, execution);
  std::vector<std::vector<std::uint32_t>> neighbors (places.size ());
  for (std::size_t node = 0; node < graph->size (); ++node) {
    const Row row = graph->row (node);
    for (std::size_t j = 0; j < row.size (); ++j)
      neighbors[graph->order ()[node]].push_back (graph->order ()[row[j]]);
  }
  return neighbors;
}
} // namespace

float
sigmaOfLargest (const NoiseSample::Residuals& residuals)
{
  const float variance = residuals.variances[of_16];
  return std::isfinite (variance) ? std::sqrt (variance / median_of_16) : 0;
}

float
spacingAt (const NoiseSample::Residuals& residuals)
{
  return static_cast<float> (spacing_of_eighth) * residuals.distance;
}

double
LocalResiduals::ratio (std::size_t s) const
{
  return spacings[s] > 0 ? sigmas[s] / spacings[s] : 0;
}

double
LocalResiduals::growthFrom (const LocalResiduals& thicker, std::size_t s) const
{
  return sigmas[s] == thicker.sigmas[s] ? 1 : sigmas[s] / thicker.sigmas[s];
}

LocalResidualsOfCloud::LocalResidualsOfCloud (ThinnedNoise& cloud, const Execution& execution)
: cloud_ (cloud), around_ (neighborsInSample (cloud.sample (0), points_of_median, execution))
{}

const LocalResiduals&
LocalResidualsOfCloud::after (int halvings)
{
  while (residuals_.size () <= static_cast<std::size_t> (halvings))
    residuals_.push_back (residualsOf (cloud_.sample (static_cast<int> (residuals_.size ()))));
  return residuals_[static_cast<std::size_t> (halvings)];
}

LocalResiduals
LocalResidualsOfCloud::residualsOf (const NoiseSample& sample) const
{
  constexpr float infinity = std::numeric_limits<float>::infinity ();
  if (sample.of_nodes.size () != size ()) // where many points lie in one place, some have no neighbours left
    return {std::vector<float> (size (), infinity), std::vector<float> (size (), infinity)};
  std::vector<float> sigmas, spacings;
  for (const NoiseSample::Residuals& of_node : sample.of_nodes) {
    sigmas.push_back (sigmaOfLargest (of_node));
    spacings.push_back (spacingAt (of_node));
  }
  return {medians (sigmas), medians (spacings)};
}

std::vector<float>
LocalResidualsOfCloud::medians (const std::vector<float>& values) const
{
  std::vector<float> result, of_neighbors;
  for (const std::vector<std::uint32_t>& neighbors : around_) {
    of_neighbors.clear ();
    for (const std::uint32_t neighbor : neighbors)
      of_neighbors.push_back (values[neighbor]);
    result.push_back (quantile (of_neighbors, .5));
  }
  return result;
}
} // namespace core
} // namespace pcl_normal_smoothing
