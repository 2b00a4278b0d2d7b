// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "thinned_noise.h"

#include <deque>
#include <vector>

namespace pcl_normal_smoothing
{
namespace core
{
/** Residuals of quadrics around the points of a sample, in a cloud thinned by a number of halvings; each is a median
  * over the point and those of the sample around it. */
struct LocalResiduals
{
  /** Residual sigma of the 16 nearest. */
  std::vector<float> sigmas;
  std::vector<float> spacings;

  /** Sigma over the spacing at a point of the sample. For any arrangement of points it falls as the cloud is
    * thinned, and shows how much of the noise quadrics follow. */
  double
  ratio (std::size_t s) const;

  /** Sigma over that in a thicker cloud; 1 if both are 0. */
  double
  growthFrom (const LocalResiduals& thicker, std::size_t s) const;
};

/** Residual sigma of the 16 nearest of one point; 0 if there are too few. */
float
sigmaOfLargest (const NoiseSample::Residuals& residuals);

/** The spacing around a point, taking its nearest to lie on a surface. */
float
spacingAt (const NoiseSample::Residuals& residuals);

/** LocalResiduals of a cloud after any number of halvings. Results are cached. */
class LocalResidualsOfCloud
{
public:
  /** Points of the sample per median: near enough to each other to show the same noise, and enough for it to be
    * known within a twentieth. */
  static constexpr std::uint32_t points_of_median = 48;

  /** \param[in] cloud of a sample with at least points_of_median points; kept while this is used */
  LocalResidualsOfCloud (ThinnedNoise& cloud, const Execution& execution);

  /** All infinity if the cloud is too thin for some points of the sample. \param[in] halvings up to mostHalvings */
  const LocalResiduals&
  after (int halvings);

  /** The points of the sample around one of them, itself included. */
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
  std::deque<LocalResiduals> residuals_; // by the number of halvings; a deque, so that references stay valid
};
} // namespace core
} // namespace pcl_normal_smoothing
