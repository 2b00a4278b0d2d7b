// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/careful_filter.h>
#include <pcl_normal_smoothing/core/chain/normal_filter.h>
#include <pcl_normal_smoothing/input_normals.h>

#include <pcl/point_types.h>

namespace pcl_normal_smoothing
{
/** Filters the normals of a cloud and keeps the edges between them: section II.B, eqs. 2 to 7, of Valdivia, Cedrim,
  * Petronetto, Paiva and Nonato, "Normal Correction Towards Smoothing Point-based Surfaces" (SIBGRAPI 2013).
  *
  * Reads xyz and the normals, those of the points or of setInputNormals; writes the normals of the points (a PointT
  * without normals is refused: see filterNormals). Everything else stays. Normals keep their signs; a point that is
  * not finite, or whose normal is not finite or zero, stays as it is and does not count for its neighbours. With
  * setIndices all normals are filtered, and those of the indexed points are written.
  *
  * k or a radius must be set, or a neighbour graph. On an error the output is empty, see filter and
  * getErrorMessage. */
template <typename PointT>
class BilateralNormalFilter : public CarefulFilter<PointT>, public InputNormals
{
public:
  using Ptr = pcl::shared_ptr<BilateralNormalFilter<PointT>>;
  using ConstPtr = pcl::shared_ptr<const BilateralNormalFilter<PointT>>;
  using PointCloud = pcl::PointCloud<PointT>;

  BilateralNormalFilter ()
  {
    this->filter_name_ = "BilateralNormalFilter";
    options_.iterations = 4;
  }

  /** How the normals of neighbours are weighted. Default NormalWeight::GAUSSIAN. */
  void
  setNormalWeight (NormalWeight weight)
  {
    options_.weight = weight;
  }

  NormalWeight
  getNormalWeight () const
  {
    return options_.weight;
  }

  /** T of eq. 3 (NormalWeight::THRESHOLD): normals with a cosine up to T do not count. Range [0, 1), default 0.65. */
  void
  setThreshold (double threshold)
  {
    options_.threshold = static_cast<float> (threshold);
  }

  double
  getThreshold () const
  {
    return options_.threshold;
  }

  /** sigma_s of eq. 5 (NormalWeight::GAUSSIAN), the standard deviation of |n_i - n_j|. Range > 0, default 0.3. */
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

  /** The threshold of eq. 7 (NormalWeight::MIXED). Default MixedThreshold::PRINTED. */
  void
  setMixedThreshold (MixedThreshold threshold)
  {
    options_.mixed_threshold = threshold;
  }

  MixedThreshold
  getMixedThreshold () const
  {
    return options_.mixed_threshold;
  }

  /** The normals are consistently oriented: none is flipped to match a neighbour, so that two close sheets do not
    * mix. Default false. */
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

  /** Number of iterations of eq. 2. Range >= 0, default 4. */
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

  /** Filters the normals of setInputNormals into a separate cloud, for point types without normals. Otherwise like
    * filter().
    * \param[out] normals one per point of the input, with its curvature; may be the cloud of setInputNormals. If the
    * run is cancelled, they are those of setInputNormals. On an error (getErrorMessage), or if no input or no
    * normals are set, the cloud of setInputNormals stays as it is, and any other output is empty */
  void
  filterNormals (pcl::PointCloud<pcl::Normal>& normals);

protected:
  /** \param[out] output the input with filtered normals. Refused for a PointT without normals: see filterNormals. */
  void
  applyFilter (PointCloud& output) override;

private:
  /** The filtered normals of the nodes of \a graph, which is set on return. */
  core::Vectors
  run (NeighborGraph::ConstPtr& graph);

  core::NormalFilterOptions options_;
};
} // namespace pcl_normal_smoothing

#ifdef PCL_NO_PRECOMPILE
#include <pcl_normal_smoothing/impl/bilateral_normal_filter.hpp>
#endif
