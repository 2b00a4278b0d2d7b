// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/noise/noise_estimate.h>
#include <pcl_normal_smoothing/search_settings.h>

#include <pcl/pcl_base.h>

namespace pcl_normal_smoothing
{
/** Tells how noisy a scan is: the standard deviation of its noise along the surface's normal, from what quadrics
  * through small neighbourhoods leave. NormalSmoothing estimates so too where setNoiseSigma gives none, but follows
  * what else it finds: where it tells close sheets apart, its sigma is that of the neighbourhoods without the other
  * sheet; where it sees past coordinates in steps, its neighbourhoods, and so its spacing, are wider ones. Its
  * usedOptions have what it used.
  *
  * Looks at a sample of about 4,096 points, chosen by their coordinates; the order of the points does not matter, and
  * points in one place count as one, but in a graph that is set. The 16 nearest points are searched, unless a graph or
  * a larger k is set. With setIndices the indexed points alone are the cloud: where these are not all that are finite,
  * a search object (setSearchMethod) is given an unorganised copy of them, and a neighbour graph is refused. */
template <typename PointT>
class SurfaceNoiseEstimation : public pcl::PCLBase<PointT>, public SearchSettings<PointT>
{
public:
  using Ptr = pcl::shared_ptr<SurfaceNoiseEstimation<PointT>>;
  using ConstPtr = pcl::shared_ptr<const SurfaceNoiseEstimation<PointT>>;

  /** Looks at the input cloud. \return false on an error, see getErrorMessage; sigma and spacing are 0 then */
  bool
  compute ();

  /** Standard deviation of the noise, in the cloud's unit; where it varies, the median over the points. 0 before
    * compute. */
  double
  getSigma () const
  {
    return estimate_.sigma;
  }

  /** Standard deviation of the noise around \a place, both in the cloud's unit: getSigma everywhere, unless the cloud
    * shows that its noise varies, as that of scanners does. 0 before compute. */
  double
  getSigmaAt (const Eigen::Vector3f& place) const
  {
    return estimate_.sigma * estimate_.field.factorAt (place);
  }

  /** Distance between neighbouring points (the median), in the cloud's unit; 0 before compute. */
  double
  getSpacing () const
  {
    return estimate_.spacing;
  }

  /** What hides the noise from small neighbourhoods, as the steps of a depth camera do. NOTHING before compute. */
  core::NoiseHiddenBy
  getHiddenBy () const
  {
    return estimate_.hidden_by;
  }

protected:
  int
  defaultK () const override
  {
    return 16;
  }

  bool
  joinsCopies () const override
  {
    return true;
  }

private:
  /** The points that are looked at: the input itself where all finite ones are indexed, else a copy of the indexed.
    * \throw core::Error where an index is out of range, or there would be a copy but a graph is set */
  typename pcl::PointCloud<PointT>::ConstPtr
  indexedPoints () const;

  core::NoiseEstimate estimate_;
};
} // namespace pcl_normal_smoothing

#ifdef PCL_NO_PRECOMPILE
#include <pcl_normal_smoothing/impl/surface_noise_estimation.hpp>
#endif
