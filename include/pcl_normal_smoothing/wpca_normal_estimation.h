// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/surface_normal_estimation.h>

namespace pcl_normal_smoothing
{
/** Normals by weighted PCA: eq. 1 of Valdivia, Cedrim, Petronetto, Paiva and Nonato, "Normal Correction Towards
  * Smoothing Point-based Surfaces" (SIBGRAPI 2013).
  *
  * A neighbour is weighted by the inverse of its distance, and the covariance is taken about the weighted centroid
  * of the other points: k must be at least 4, or 3 with a search surface (setSearchSurface). Works wherever a
  * pcl::Feature does. */
template <typename PointInT, typename PointOutT>
class WPCANormalEstimation : public SurfaceNormalEstimation<PointInT, PointOutT>
{
public:
  using Ptr = pcl::shared_ptr<WPCANormalEstimation<PointInT, PointOutT>>;
  using ConstPtr = pcl::shared_ptr<const WPCANormalEstimation<PointInT, PointOutT>>;

  WPCANormalEstimation ()
  {
    this->feature_name_ = "WPCANormalEstimation";
  }

protected:
  core::SurfaceEstimator
  makeEstimator () const override
  {
    // On another surface, all points are others.
    const bool without_itself = !this->surface_ || this->surface_ == this->input_;
    if (!this->neighbor_graph_)
      core::checkNeighborCount (without_itself ? NormalSource::WPCA : NormalSource::PCA, this->k_);
    return core::makeEstimator (NormalSource::WPCA, {});
  }
};
} // namespace pcl_normal_smoothing

#ifdef PCL_NO_PRECOMPILE
#include <pcl_normal_smoothing/impl/wpca_normal_estimation.hpp>
#endif
