// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/chain/surface_estimation.h>
#include <pcl_normal_smoothing/neighbor_graph.h>
#include <pcl_normal_smoothing/run_settings.h>

#include <pcl/features/feature.h>
#include <pcl/point_types.h>

namespace pcl_normal_smoothing
{
/** The common part of this module's normal estimators: which neighbourhoods they use, and which way normals point.
  *
  * Reads xyz; writes normal and curvature (the surface variation), one output per index. A point that is not finite, or
  * whose neighbourhood has fewer than 3 points (WPCA: without the point itself) or lies on a line, gets NaN, and the
  * output is not dense. Normals point to the viewpoint, like those of pcl::NormalEstimation.
  *
  * k or a radius must be set, or a neighbour graph; a k too small for any normal is an error. On an error the output
  * is empty; see getErrorMessage. */
template <typename PointInT, typename PointOutT>
class SurfaceNormalEstimation : public pcl::Feature<PointInT, PointOutT>, public RunSettings
{
public:
  using Ptr = pcl::shared_ptr<SurfaceNormalEstimation<PointInT, PointOutT>>;
  using ConstPtr = pcl::shared_ptr<const SurfaceNormalEstimation<PointInT, PointOutT>>;
  using PointCloudOut = pcl::PointCloud<PointOutT>;

  /** Normals point to (\a x, \a y, \a z). Default: the input's sensor origin. */
  void
  setViewPoint (float x, float y, float z)
  {
    view_point_ = Eigen::Vector3f (x, y, z);
    use_sensor_origin_ = false;
  }

  /** The viewpoint of setViewPoint, otherwise the sensor origin of the input cloud, zero without a cloud. */
  void
  getViewPoint (float& x, float& y, float& z) const
  {
    // Here and not in impl: the classes compiled into the library do not instantiate all members of their base.
    Eigen::Vector3f view_point = view_point_;
    if (use_sensor_origin_)
      view_point = this->input_ ? Eigen::Vector3f (this->input_->sensor_origin_.template head<3> ())
                                : Eigen::Vector3f (Eigen::Vector3f::Zero ());
    x = view_point.x ();
    y = view_point.y ();
    z = view_point.z ();
  }

  /** Normals point to the sensor origin of the input cloud. */
  void
  useSensorOriginAsViewPoint ()
  {
    use_sensor_origin_ = true;
  }

protected:
  /** The estimator of one run. \throw core::Error where a parameter is out of range */
  virtual core::SurfaceEstimator
  makeEstimator () const = 0;

  /** Like PCL's, but builds no tree, and needs no k if a graph is set. */
  bool
  initCompute () override;

private:
  void
  computeFeature (PointCloudOut& output) override;

  /** One surface for every index. */
  std::vector<core::LocalSurface>
  estimate ();

  std::vector<core::LocalSurface>
  estimateOverGraph (const core::SurfaceEstimator& estimator);

  /** Used if the surface is another cloud, or if only some points are indexed. */
  std::vector<core::LocalSurface>
  estimateByQueries (const core::SurfaceEstimator& estimator);

  /** Flips the normal of a surface towards the viewpoint and stores it. */
  void
  store (const core::LocalSurface& surface, const Eigen::Vector3f& to_view_point, PointOutT& output) const;

  Eigen::Vector3f view_point_ = Eigen::Vector3f::Zero ();
  bool use_sensor_origin_ = true;
};
} // namespace pcl_normal_smoothing
