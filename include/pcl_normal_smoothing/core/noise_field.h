// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/parallel_for.h>
#include <pcl_normal_smoothing/core/positions.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** How the noise of a cloud varies from place to place: a scanner measures worse what is far, dark or slanting. Regions, each with
  * its part of the cloud's sigma. */
struct NoiseField
{
  struct Region
  {
    /** The middle of its box, and the distance from there to the corners, > 0: in the unit of the positions. */
    Eigen::Vector3f centre;
    float reach;
    /** sigma there over that of the cloud, > 0. */
    float factor;
  };

  /** None: the noise is the same everywhere. */
  std::vector<Region> regions;

  bool
  isEven () const
  {
    return regions.empty ();
  }

  /** sigma at a place over that of the cloud: a mean of the regions, the nearer ones counting for more. 1 far away. */
  float
  factorAt (const Eigen::Vector3f& place) const;

  float
  smallestFactor () const;

  float
  largestFactor () const;

  /** The same for positions in another unit: see Positions::unit. */
  NoiseField
  inUnit (double unit) const;
};

/** What one point shows of the noise around it. */
struct LocalNoise
{
  Eigen::Vector3f place;
  float variance;
};

/** \param[in] sample of the whole cloud, in any order
  * \param[in] spacing between neighbouring points, > 0
  * \param[in] ratio sigma over it: the smaller, the more must regions differ, for detail looks like noise
  * \return the factor 1 is the median of the sample; no regions where they hardly differ, or the sample is too small to tell */
NoiseField
estimateNoiseField (const std::vector<LocalNoise>& sample, float spacing, double ratio);

/** The squares of factorAt for all nodes; empty where the field is even. */
Numbers
varianceFactors (const NoiseField& field, const Positions& positions, const Execution& execution);
} // namespace core
} // namespace pcl_normal_smoothing
