// SPDX-License-Identifier: BSD-3-Clause
#include "thinned_noise.h"

#include "../quantile.h"
#include "thinned_sample.h"

#include "../search/hash_sample.h"
#include "../search/thinned_cloud.h"
#include "cloud_thickness.h"
#include "noise_of_sample.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
constexpr double min_share_turned = .06;
constexpr double max_cosine_turned = .7;

/** The finite residual variances of the largest neighbourhoods. */
std::vector<float>
variancesOf (const NoiseSample& sample)
{
  std::vector<float> variances;
  for (const NoiseSample::Residuals& residuals : sample.of_nodes)
    if (std::isfinite (residuals.variances.back ()))
      variances.push_back (residuals.variances.back ());
  return variances;
}
} // namespace

double
ThinnedNoise::ratio (int halvings)
{
  const NoiseEstimate& of_cloud = noise (halvings);
  return of_cloud.spacing > 0 ? of_cloud.sigma / of_cloud.spacing : 0;
}

const ThinnedNoise::Shown&
ThinnedNoise::shown (int halvings)
{
  while (shown_.size () <= static_cast<std::size_t> (halvings)) {
    NoiseSample sample = thinnedSample (static_cast<int> (shown_.size ()));
    const NoiseEstimate noise = noiseOfThinnedSample (sample);
    const std::vector<float> variances = variancesOf (sample);
    const double upper = quantile (variances, .75), lower = quantile (variances, .25);
    shown_.push_back ({std::move (sample), noise, std::sqrt (upper), lower > 0 ? upper / lower : 0});
  }
  return shown_[static_cast<std::size_t> (halvings)];
}

ThinnedNoise::ThinnedNoise (const NeighborGraph& graph, const Positions& nodes, const Execution& execution)
: graph_ (graph), nodes_ (nodes), execution_ (execution), sample_ (sampleNodes (nodes, noise_sample_size, execution))
{}

int
ThinnedNoise::mostHalvings () const
{
  return ThinnedCloud::mostHalvings (nodes_.size (), ThinnedCloud::least_size);
}

NoiseSample
ThinnedNoise::thinnedSample (int halvings) const
{
  const std::uint32_t length = rowLength ();
  if (halvings == 0 || sample_.empty ())
    return sampleNoise (graph_, nodes_, sample_, nodes_.size (), execution_);
  const ThinnedCloud thinned (graph_, nodes_, halvings, ThinnedCloud::Parts::SOME, execution_);
  std::vector<std::uint32_t> rows (sample_.size () * length);
  KdTree::Scratch scratch;
  for (std::size_t s = 0; s < sample_.size (); ++s)
    thinned.row (sample_[s], rows.data () + s * length, length, scratch);
  return sampleNoise (*graph_.withRows (sample_, rows, length), nodes_, sample_, nodes_.size (), execution_);
}

std::vector<Differences>
ThinnedNoise::differencesAfter (int halvings) const
{
  return ThinnedSample (graph_, nodes_, sample_, execution_).differencesAfter (halvings);
}

bool
ThinnedNoise::hasTurningPlanes () const
{
  std::size_t turned = 0, all = 0;
  for (const Differences& differences : quickSample (graph_, nodes_, execution_)) {
    const PrincipalAxes half = axesOfNearest (differences, noise_row_length / 2);
    const double cosine = half.normal.dot (axesOfNearest (differences, noise_row_length).normal);
    turned += std::abs (cosine) < max_cosine_turned ? 1 : 0;
    ++all;
  }
  return static_cast<double> (turned) > min_share_turned * static_cast<double> (all);
}

double
ThinnedNoise::thickness () const
{
  return cloudThickness (nodes_, execution_);
}
} // namespace core
} // namespace pcl_normal_smoothing
