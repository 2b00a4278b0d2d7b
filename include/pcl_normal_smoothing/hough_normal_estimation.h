// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/surface_normal_estimation.h>

namespace pcl_normal_smoothing
{
/** Normals by the randomised Hough transform of Boulch and Marlet, "Fast and Robust Normal Estimation for Point Clouds
  * with Sharp Features" (SGP 2012), section II.A of Valdivia et al. 2013.
  *
  * Planes through random triples of neighbours vote for a normal; beside an edge the face with more neighbours wins
  * where PCA mixes the two. The same result for the same seed, whatever the threads and the order of the points. */
template <typename PointInT, typename PointOutT>
class HoughNormalEstimation : public SurfaceNormalEstimation<PointInT, PointOutT>
{
public:
  using Ptr = pcl::shared_ptr<HoughNormalEstimation<PointInT, PointOutT>>;
  using ConstPtr = pcl::shared_ptr<const HoughNormalEstimation<PointInT, PointOutT>>;

  HoughNormalEstimation ()
  {
    this->feature_name_ = "HoughNormalEstimation";
  }

  /** Probability that the votes are close to their distribution. Range (0, 1), default 0.95. */
  void
  setConfidence (double confidence)
  {
    options_.confidence = static_cast<float> (confidence);
  }

  double
  getConfidence () const
  {
    return options_.confidence;
  }

  /** How close the votes must be to their distribution. Range [0.001, 1), default 0.08; the number of triples grows
    * with its inverse square. */
  void
  setTolerance (double tolerance)
  {
    options_.tolerance = static_cast<float> (tolerance);
  }

  double
  getTolerance () const
  {
    return options_.tolerance;
  }

  /** Number of bands of the accumulator between the poles. Range [2, 1000], default 15. */
  void
  setNumberOfBands (int bands)
  {
    options_.bands = bands;
  }

  int
  getNumberOfBands () const
  {
    return options_.bands;
  }

  /** Number of randomly rotated accumulators. Range [1, 1000], default 5. */
  void
  setNumberOfRotations (int rotations)
  {
    options_.rotations = rotations;
  }

  int
  getNumberOfRotations () const
  {
    return options_.rotations;
  }

  /** Seed of the random triples and rotations. Default 0. */
  void
  setSeed (std::uint64_t seed)
  {
    options_.seed = seed;
  }

  std::uint64_t
  getSeed () const
  {
    return options_.seed;
  }

protected:
  core::SurfaceEstimator
  makeEstimator () const override
  {
    if (!this->neighbor_graph_)
      core::checkNeighborCount (NormalSource::HOUGH, this->k_);
    return core::makeEstimator (NormalSource::HOUGH, options_);
  }

private:
  core::HoughOptions options_;
};
} // namespace pcl_normal_smoothing

#ifdef PCL_NO_PRECOMPILE
#include <pcl_normal_smoothing/impl/hough_normal_estimation.hpp>
#endif
