// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/chain/local_surface.h>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <limits>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
// Below this share of the trace in the middle eigenvalue, points lie on a line, and any normal across it would fit.
constexpr double collinear = 1e-10;

/** Sums over weighted points, sufficient for the covariance about their centroid. */
class Moments
{
public:
  void
  add (const Eigen::Vector3d& point, double weight)
  {
    weight_ += weight;
    sum_ += weight * point;
    outer_ += weight * point * point.transpose ();
  }

  LocalSurface
  surface () const
  {
    // Coordinates relative to the point are as small as the neighbourhood: in double, subtracting the mean loses
    // nothing.
    const Eigen::Matrix3d covariance = outer_ / weight_ - sum_ * sum_.transpose () / (weight_ * weight_);
    const double scale = covariance.trace ();
    if (!(scale > 0) || !std::isfinite (scale))
      return LocalSurface::invalid ();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver (covariance / scale);
    if (solver.eigenvalues ()[1] < collinear)
      return LocalSurface::invalid ();
    const double smallest = std::max (0.0, solver.eigenvalues ()[0]);
    return {solver.eigenvectors ().col (0).cast<float> ().normalized (), static_cast<float> (smallest)};
  }

private:
  double weight_ = 0;
  Eigen::Vector3d sum_ = Eigen::Vector3d::Zero ();
  Eigen::Matrix3d outer_ = Eigen::Matrix3d::Zero ();
};
} // namespace

LocalSurface
LocalSurface::invalid ()
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN ();
  return {Eigen::Vector3f::Constant (nan), nan};
}

LocalSurface
pcaSurface (const Neighborhood& neighborhood)
{
  if (neighborhood.size () < 3)
    return LocalSurface::invalid ();
  Moments moments;
  for (std::size_t j = 0; j < neighborhood.size (); ++j)
    moments.add (neighborhood[j].cast<double> (), 1.0);
  return moments.surface ();
}

LocalSurface
wpcaSurface (const Neighborhood& neighborhood)
{
  if (neighborhood.size () < 3)
    return LocalSurface::invalid ();
  Moments moments;
  for (std::size_t j = 0; j < neighborhood.size (); ++j) {
    const Eigen::Vector3d difference = neighborhood[j].cast<double> ();
    const double distance = difference.norm ();
    if (distance > 0)
      moments.add (difference, 1 / distance); // eq. 1
  }
  return moments.surface ();
}
} // namespace core
} // namespace pcl_normal_smoothing
