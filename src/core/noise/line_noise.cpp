// SPDX-License-Identifier: BSD-3-Clause
#include "line_noise.h"

#include "../quantile.h"

#include <array>
#include <cmath>
#include <limits>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
constexpr std::size_t least_nodes = 64;
constexpr std::size_t parabola_coefficients = 3;

// Upper bound on growth with more points: noise as wide as the spacing along the line grows less, another line more.
constexpr double max_growth = 1.5;

struct Size
{
  std::size_t points;
  double median; // of chi-square over its degrees of freedom: points - parabola_coefficients
};
constexpr std::array<Size, 3> sizes {{{8, .8703}, {12, .9270}, {16, .9492}}};

/** Residual variance across the line after the fit of a parabola. */
double
varianceAcross (const Differences& differences, std::size_t count)
{
  const Eigen::Vector3d mean = meanOfNearest (differences, count),
                        direction = axesOfNearest (differences, count).direction;
  std::vector<double> along;
  double sq_sum = 0, cube_sum = 0;
  for (std::size_t j = 0; j < count; ++j) {
    const double t = direction.dot (differences[j] - mean);
    along.push_back (t);
    sq_sum += t * t;
    cube_sum += t * t * t;
  }
  if (!(sq_sum > 0))
    return 0;
  // Only the curvature is left to fit: about the principal axis, points have no mean and no slope.
  double sq_across = 0, sq_bend = 0;
  Eigen::Vector3d bent = Eigen::Vector3d::Zero ();
  for (std::size_t j = 0; j < count; ++j) {
    const double t = along[j], bend = t * t - sq_sum / static_cast<double> (count) - cube_sum / sq_sum * t;
    const Eigen::Vector3d across = differences[j] - mean - t * direction;
    sq_across += across.squaredNorm ();
    sq_bend += bend * bend;
    bent += bend * across;
  }
  const double left = sq_bend > 0 ? sq_across - bent.squaredNorm () / sq_bend : sq_across;
  return std::max (left, 0.0) / static_cast<double> (count - parabola_coefficients);
}

double
noiseOf (const std::vector<Differences>& of_nodes, const Size& size)
{
  std::vector<float> variances;
  for (const Differences& differences : of_nodes)
    variances.push_back (static_cast<float> (varianceAcross (differences, size.points)));
  return std::sqrt (quantile (std::move (variances), .5) / size.median);
}
} // namespace

double
noiseAlongLines (const std::vector<Differences>& of_nodes)
{
  if (of_nodes.size () < least_nodes)
    return std::numeric_limits<double>::infinity ();
  double noise = noiseOf (of_nodes, sizes.front ());
  for (std::size_t size = 1; size < sizes.size (); ++size) {
    const double of_more = noiseOf (of_nodes, sizes[size]);
    if (!(of_more < max_growth * noise))
      break;
    noise = of_more;
  }
  return noise;
}
} // namespace core
} // namespace pcl_normal_smoothing
