// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/noise/noise_estimate.h>
#include <pcl_normal_smoothing/search_settings.h>

#include <pcl/pcl_base.h>

namespace pcl_normal_smoothing
{
/** Estimates how noisy a scan is: the standard deviation of its noise along the surface's normal, from the residuals of
  * quadrics through small neighbourhoods. NormalSmoothing estimates in the same way if setNoiseSigma gives none, but
  * takes into account what else it finds: if it separates close sheets, its sigma is that of neighbourhoods without the
  * other sheet; if it sees past coordinates in steps, its neighbourhoods, and hence its spacing, are wider. Its
  * usedOptions contain what it used.
  *
  * Uses a sample of about 4,096 points, chosen by their coordinates; the order of the points does not matter, and
  * points in one place count as one, unless a graph is set. Searches the 16 nearest points, unless k, a radius or a
  * graph is set; where that gives a point fewer, the 16 nearest of the sample are searched besides, and noise wider
  * than the spacing is not looked for. With setIndices only the indexed points are the cloud: if these are not all finite points, a
  * search object (setSearchMethod) is given an unorganised copy of them, and a neighbour graph is refused. */
template <typename PointT>
class SurfaceNoiseEstimation : public pcl::PCLBase<PointT>, public SearchSettings<PointT>
{
public:
  using Ptr = pcl::shared_ptr<SurfaceNoiseEstimation<PointT>>;
  using ConstPtr = pcl::shared_ptr<const SurfaceNoiseEstimation<PointT>>;

  /** Estimates the noise of the input cloud. \return false on an error or if cancelled, see getErrorMessage; sigma
    * and spacing are then 0 */
  bool
  compute ();

  /** Standard deviation of the noise, in the cloud's unit; if it varies, the median over the points. 0 before
    * compute. */
  double
  getSigma () const
  {
    return estimate_.sigma;
  }

  /** Standard deviation of the noise around \a place, both in the cloud's unit: getSigma everywhere, unless the
    * cloud shows that its noise varies, as that of scanners does. 0 before compute. */
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
  /** The points that are used: the input itself if all finite points are indexed, else a copy of the indexed ones.
    * \throw core::Error if an index is out of range, or if a copy is needed but a graph is set */
  typename pcl::PointCloud<PointT>::ConstPtr
  indexedPoints () const;

  core::NoiseEstimate estimate_;
};
} // namespace pcl_normal_smoothing

#ifdef PCL_NO_PRECOMPILE
#include <pcl_normal_smoothing/impl/surface_noise_estimation.hpp>
#endif
