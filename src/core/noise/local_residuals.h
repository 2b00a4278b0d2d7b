// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "thinned_noise.h"

#include <deque>
#include <vector>

namespace pcl_normal_smoothing
{
namespace core
{
/** What quadrics leave about the points of a sample where so many halvings thin the cloud, each a median over the point
  * and those of the sample around it. */
struct LocalResiduals
{
  /** Of the 16 nearest, as sigma. */
  std::vector<float> sigmas;
  std::vector<float> spacings;

  /** Of a point of the sample: sigma to the spacing. However the points lie it falls as the cloud is thinned, and tells
    * how much of the noise quadrics follow. */
  double
  ratio (std::size_t s) const;

  /** How many times as large sigma is there as in another cloud; 1 where both are 0. */
  double
  growthFrom (const LocalResiduals& thicker, std::size_t s) const;
};

/** What quadrics leave of the 16 nearest of one point, as sigma; 0 where there are too few. */
float
sigmaOfLargest (const NoiseSample::Residuals& residuals);

/** Of the points near to one, as the nearest of a surface are spread. */
float
spacingAt (const NoiseSample::Residuals& residuals);

/** Those of a cloud, halved again and again. What was asked for is kept. */
class LocalResidualsOfCloud
{
public:
  /** Of the sample, so near to each other that they show the same noise, and so many that it is known within a
    * twentieth. */
  static constexpr std::uint32_t points_of_median = 48;

  /** \param[in] cloud of a sample with at least points_of_median points; kept while this is used */
  LocalResidualsOfCloud (ThinnedNoise& cloud, const Execution& execution);

  /** Infinity where the cloud is too thin for all points of the sample. \param[in] halvings up to mostHalvings */
  const LocalResiduals&
  after (int halvings);

  /** A point of the sample, and those around it. */
  const std::vector<std::uint32_t>&
  around (std::size_t s) const
  {
    return around_[s];
  }

  std::size_t
  size () const
  {
    return around_.size ();
  }

  int
  mostHalvings () const
  {
    return cloud_.mostHalvings ();
  }

private:
  LocalResiduals
  residualsOf (const NoiseSample& sample) const;

  std::vector<float>
  medians (const std::vector<float>& values) const;

  ThinnedNoise& cloud_;
  std::vector<std::vector<std::uint32_t>> around_;
  std::deque<LocalResiduals> residuals_; // by the number of halvings; what was given out stays where it is
};
} // namespace core
} // namespace pcl_normal_smoothing
