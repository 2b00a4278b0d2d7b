// SPDX-License-Identifier: BSD-3-Clause
#include "noise_of_sample.h"

namespace pcl_normal_smoothing
{
namespace core
{
NoiseEstimate
estimateNoise (const NeighborGraph& graph, const Positions& nodes, const Execution& execution)
{
  const Widening widening = estimateWidening (graph, nodes, execution);
  NoiseEstimate noise = noiseOfSample (sampleNoise (graph, nodes, execution), widening.roundingAlone ());
  noise.hidden_by = widening.hiddenBy ();
  if (widening.projects ())
    return {widening.wide_noise.sigma, noise.spacing, widening.wide_noise.field, noise.hidden_by};
  const auto wide = widenNeighborhoods (graph, nodes, widening, execution);
  if (!wide)
    return noise;
  const NoiseEstimate of_wide = noiseOfSample (sampleNoise (*wide, nodes, execution), widening);
  return {of_wide.sigma, noise.spacing, of_wide.field, noise.hidden_by};
}
} // namespace core
} // namespace pcl_normal_smoothing
