// SPDX-License-Identifier: BSD-3-Clause
#include "layer_test.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
// In distances of the eighth nearest: deviation from a plane that rounding explains, and height of a point surely off
// it.
constexpr double flat_height = 1.2e-3;
constexpr double off_height = 1.2e-2;
constexpr int min_neighbors_off = 8; // fewer points of another sheet may lie to one side by chance
// Points above or below lie to one side if their mean way along the plane is more than this share of its mean length;
// and the node's own plane has ended there if its points reach less than this share of that way.
constexpr double min_share_aside = .6;
constexpr double max_share_beneath = .25;
constexpr double max_highest_over_lowest = 1.1; // ratio of heights within one layer

/** The points above a node, below it, or in its plane. */
class Part
{
public:
  void
  add (const Eigen::Vector3d& along, double height)
  {
    lowest_ = std::min (lowest_, height);
    highest_ = std::max (highest_, height);
    sum_ += along;
    length_ += along.norm ();
    ++count_;
  }

  /** Whether there are none, or they lie in one plane, to one side of the node, and not the side on which its own
    * plane continues, as at the rim of a plate. */
  bool
  isEmptyOrNextLayer (const Part& own) const
  {
    return count_ == 0 || (highest_ < max_highest_over_lowest * lowest_ && sum_.norm () > min_share_aside * length_ &&
                           own.mean ().dot (mean ()) < max_share_beneath * mean ().squaredNorm ());
  }

  /** Infinity if there are no points. */
  double
  lowest () const
  {
    return lowest_;
  }

  int
  count () const
  {
    return count_;
  }

private:
  Eigen::Vector3d
  mean () const
  {
    return sum_ / std::max (count_, 1);
  }

  double lowest_ = std::numeric_limits<double>::infinity (), highest_ = 0, length_ = 0;
  Eigen::Vector3d sum_ = Eigen::Vector3d::Zero ();
  int count_ = 0;
};
} // namespace

std::optional<Eigen::Vector3d>
planeOf (const Differences& differences)
{
  const PrincipalAxes axes = axesOfNearest (differences);
  const double flat = flat_height * differences[nearest_count - 1].norm ();
  if (!(axes.variances[1] > flat * flat)) // copies, or points on a line
    return {};
  const Eigen::Vector3d mean = meanOfNearest (differences);
  const bool is_plane =
      std::all_of (differences.begin (), differences.begin () + nearest_count,
                   [&] (const auto& difference) { return std::abs (axes.normal.dot (difference - mean)) < flat; });
  return is_plane ? std::make_optional (axes.normal) : std::nullopt;
}

LayerSurrounding
layerSurrounding (const Differences& differences, const Eigen::Vector3d& normal)
{
  const double off = off_height * differences[nearest_count - 1].norm ();
  Part above, below, own;
  for (const Eigen::Vector3d& difference : differences) {
    const double height = normal.dot (difference);
    Part& part = std::abs (height) < off ? own : height > 0 ? above : below;
    part.add (difference - height * normal, std::abs (height));
  }
  if (above.count () + below.count () < min_neighbors_off)
    return {};
  const bool are_layers = above.isEmptyOrNextLayer (own) && below.isEmptyOrNextLayer (own);
  const double nearest = std::min (above.lowest (), below.lowest ());
  return {true, are_layers ? nearest : 0, nearest};
}
} // namespace core
} // namespace pcl_normal_smoothing
