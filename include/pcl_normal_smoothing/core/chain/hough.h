// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/chain/local_surface.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** The randomised Hough transform of Boulch and Marlet, "Fast and Robust Normal Estimation for Point Clouds with Sharp
  * Features" (SGP 2012). */
struct HoughOptions
{
  /** a: probability that the votes are close to their distribution, in (0, 1). */
  float confidence = 0.95f;
  /** d: how close, in [0.001, 1). At most T = ln (2 M / (1 - a)) / (2 d^2) triples are drawn, M the number of bins. */
  float tolerance = 0.08f;
  /** n_phi: number of bands between the poles, each as high as a bin, 2 to 1000. */
  int bands = 15;
  /** Number of randomly rotated accumulators, against the bias of the grid, 1 to 1000. */
  int rotations = 5;
  std::uint64_t seed = 0;
};

/** Lets planes through triples of neighbours vote for normals. The result depends only on the seed and the
  * coordinates, not on what else is computed or in which order. */
class HoughEstimator
{
public:
  /** \throw Error if an option is out of range */
  explicit HoughEstimator (const HoughOptions& options);

  /** The mean normal of the bin with most votes, averaged over the rotations; the surface variation is that of PCA. */
  LocalSurface
  estimate (const Neighborhood& neighborhood) const;

  /** M: number of bins on a hemisphere. */
  std::size_t
  binCount () const
  {
    return static_cast<std::size_t> (band_begin_.back ());
  }

  /** T: upper bound on the triples drawn for a point. */
  std::size_t
  maxTriples () const
  {
    return max_triples_;
  }

private:
  struct Bin
  {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero ();
    std::uint32_t votes = 0;
  };
  class TripleSource;
  struct Ballot;

  using RowMajorMatrix = Eigen::Matrix<float, 3, 3, Eigen::RowMajor>;

  /** Lets triples vote in one accumulator, 16 at a time, until the winner is clear or its share of triples is drawn.
    * \return the mean normal of the winning bin; zero if no triple spans a plane */
  Eigen::Vector3f
  vote (const RowMajorMatrix& rotation, const Vectors& points, TripleSource& triples, std::vector<Bin>& bins) const;

  HoughOptions options_;
  std::vector<float> band_begin_;  // first bin of each band, then M
  std::vector<float> band_cosine_; // of the angle from the pole at which each band ends
  std::size_t max_triples_ = 0;
  std::vector<RowMajorMatrix> rotations_;
};
} // namespace core
} // namespace pcl_normal_smoothing
