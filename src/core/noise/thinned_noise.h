// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "differences.h"
#include "noise_sample.h"

#include <pcl_normal_smoothing/core/noise/noise_estimate.h>

#include <cstdint>
#include <deque>
#include <vector>

namespace pcl_normal_smoothing
{
namespace core
{
/** The estimate from the sample of a thinned cloud. There detail looks like clumps, so that none are looked for. */
NoiseEstimate
estimateThinnedNoise (const NoiseSample& sample);

/** The noise as neighbourhoods in thinner clouds show it: in all of a cloud, in half of it, a quarter ... What was
  * asked for is kept. */
class ThinnedNoise
{
public:
  /** \param[in] graph of all nodes, its rows have at least 16 points; all kept while this is used */
  ThinnedNoise (const NeighborGraph& graph, const Positions& nodes, const Execution& execution);

  /** How often the cloud can be halved. */
  int
  mostHalvings () const;

  /** Where so many halvings thin the cloud, up to mostHalvings; 0: as it is. */
  const NoiseSample&
  sample (int halvings)
  {
    return shown (halvings).sample;
  }

  const NoiseEstimate&
  noise (int halvings)
  {
    return shown (halvings).noise;
  }

  /** Of sigma to the spacing of the thinned cloud; 0 where too few distinct points are left. */
  double
  ratio (int halvings);

  /** Of the largest neighbourhoods, the upper quartile over the sample of what their quadrics leave: a length. */
  double
  residual (int halvings)
  {
    return shown (halvings).residual;
  }

  /** Of the largest neighbourhoods, the upper quartile over the lower one of the variances that their quadrics leave:
    * of one noise quartile_ratio_of_16, of two sheets less, of detail more. */
  double
  spread (int halvings)
  {
    return shown (halvings).spread;
  }

  /** From the points of the sample to their nearest where so many halvings thin the cloud: see ThinnedSample. */
  std::vector<Differences>
  differencesAfter (int halvings) const;

  /** Whether planes through the nearest half of a neighbourhood often are others than those through all of it: where it
    * is a ball or a ribbon inside the noise. */
  bool
  hasTurningPlanes () const;

  /** See core/noise/cloud_thickness.h. */
  double
  thickness () const;

  /** Of the nodes. */
  std::size_t
  size () const
  {
    return nodes_.size ();
  }

  std::uint32_t
  rowLength () const
  {
    return static_cast<std::uint32_t> (graph_.minRowLength ());
  }

private:
  struct Shown
  {
    NoiseSample sample;
    NoiseEstimate noise;
    double residual, spread;
  };

  const Shown&
  shown (int halvings);

  NoiseSample
  thinnedSample (int halvings) const;

  const NeighborGraph& graph_;
  const Positions& nodes_;
  const Execution& execution_;
  std::vector<std::uint32_t> sample_;
  std::deque<Shown> shown_; // by the number of halvings; what was given out stays where it is
};
} // namespace core
} // namespace pcl_normal_smoothing
