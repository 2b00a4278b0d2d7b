// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/careful_filter.h>
#include <pcl_normal_smoothing/core/chain/point_update.h>
#include <pcl_normal_smoothing/input_normals.h>

#include <pcl/point_types.h>

namespace pcl_normal_smoothing
{
/** Moves the points of a cloud to fit their normals: section II.C, eqs. 8 and 9, of Valdivia, Cedrim, Petronetto, Paiva
  * and Nonato, "Normal Correction Towards Smoothing Point-based Surfaces" (SIBGRAPI 2013), or the compensated form that
  * does not drift on curved surfaces (UpdateRule).
  *
  * Reads xyz and the normals, those of the points or of setInputNormals; writes xyz. Everything else stays. A point
  * that is not finite, or whose normal is not finite or zero, stays where it is and moves no other. With setIndices
  * all points move, and the positions of the indexed ones are written.
  *
  * k or a radius must be set, or a neighbour graph. On an error the output is empty, see filter and
  * getErrorMessage. */
template <typename PointT>
class NormalGuidedPointUpdate : public CarefulFilter<PointT>, public InputNormals
{
public:
  using Ptr = pcl::shared_ptr<NormalGuidedPointUpdate<PointT>>;
  using ConstPtr = pcl::shared_ptr<const NormalGuidedPointUpdate<PointT>>;
  using PointCloud = pcl::PointCloud<PointT>;

  NormalGuidedPointUpdate ()
  {
    this->filter_name_ = "NormalGuidedPointUpdate";
    options_.iterations = 2;
  }

  /** How points move. Default UpdateRule::COMPENSATED. */
  void
  setUpdateRule (UpdateRule rule)
  {
    options_.rule = rule;
  }

  UpdateRule
  getUpdateRule () const
  {
    return options_.rule;
  }

  /** sigma_s of eq. 9, the standard deviation of 1 - |n_i.n_j|. Range > 0, default 0.03; the paper has 1/3. */
  void
  setSigmaS (double sigma_s)
  {
    options_.sigma_s = static_cast<float> (sigma_s);
  }

  double
  getSigmaS () const
  {
    return options_.sigma_s;
  }

  /** The normals are consistently oriented: the signed n_i.n_j is used, so that two close sheets do not attract each
    * other. Default false. */
  void
  setNormalsOriented (bool oriented)
  {
    options_.oriented = oriented;
  }

  bool
  getNormalsOriented () const
  {
    return options_.oriented;
  }

  /** Number of iterations of eq. 8. Range >= 0, default 2. */
  void
  setMaxIterations (int iterations)
  {
    options_.iterations = iterations;
  }

  int
  getMaxIterations () const
  {
    return options_.iterations;
  }

  /** Upper bound on the distance of a point from its start, in the cloud's unit. Range > 0, default infinity: no
    * limit. */
  void
  setMaxDisplacement (double distance)
  {
    max_displacement_ = distance;
  }

  double
  getMaxDisplacement () const
  {
    return max_displacement_;
  }

  /** Neighbours are searched again after this many iterations, range >= 0. Default 0: never. */
  void
  setSearchInterval (int iterations)
  {
    options_.search_interval = iterations;
  }

  int
  getSearchInterval () const
  {
    return options_.search_interval;
  }

protected:
  /** \param[out] output the input with moved points */
  void
  applyFilter (PointCloud& output) override;

private:
  core::PointUpdateOptions options_; // except for the displacement
  double max_displacement_ = std::numeric_limits<double>::infinity ();
};
} // namespace pcl_normal_smoothing

#ifdef PCL_NO_PRECOMPILE
#include <pcl_normal_smoothing/impl/normal_guided_point_update.hpp>
#endif
