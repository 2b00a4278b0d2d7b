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
/** The noise as shown by neighbourhoods in the whole cloud, in half of it, a quarter and so on. Results are cached. */
class ThinnedNoise
{
public:
  /** \param[in] graph of all nodes, with rows of at least 16 points; all arguments kept while this is used */
  ThinnedNoise (const NeighborGraph& graph, const Positions& nodes, const Execution& execution);

  /** Upper bound on the number of halvings. */
  int
  mostHalvings () const;

  /** After the given number of halvings, up to mostHalvings; 0: the cloud as it is. */
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

  /** Sigma over the spacing of the thinned cloud; 0 if too few distinct points are left. */
  double
  ratio (int halvings);

  /** Upper quartile over the sample of the residuals of the largest neighbourhoods; a length. */
  double
  residual (int halvings)
  {
    return shown (halvings).residual;
  }

  /** Upper over lower quartile of the residual variances of the largest neighbourhoods: quartile_ratio_of_16 for
    * even noise, less for two sheets, more for detail. */
  double
  spread (int halvings)
  {
    return shown (halvings).spread;
  }

  /** Differences from the points of the sample to their nearest after that number of halvings: see ThinnedSample. */
  std::vector<Differences>
  differencesAfter (int halvings) const;

  /** Whether planes through the nearest half of a neighbourhood often differ from those through all of it, as when
    * it is a ball or a ribbon inside the noise. */
  bool
  hasTurningPlanes () const;

  /** See core/noise/cloud_thickness.h. */
  double
  thickness () const;

  /** Number of nodes. */
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
  std::deque<Shown> shown_; // by the number of halvings; a deque, so that references stay valid
};
} // namespace core
} // namespace pcl_normal_smoothing
