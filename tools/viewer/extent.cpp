// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/extent.h"

#include <algorithm>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
constexpr std::size_t most_points = 20000;
constexpr std::size_t outer_share = 500; // one point in so many may lie outside, at either end

double
nth (std::vector<double>& numbers, std::size_t place)
{
  std::nth_element (numbers.begin (), numbers.begin () + static_cast<std::ptrdiff_t> (place), numbers.end ());
  return numbers[place];
}
} // namespace

Extent::Extent (const Surface& surface)
{
  const std::size_t count = surface.nodes.size (), step = 1 + count / most_points;
  for (std::size_t i = 0; i < count; i += step)
    points_.push_back (surface.position (i));
  std::vector<double> along (points_.size ());
  const std::size_t outer = points_.size () / outer_share;
  for (int d = 0; d < 3; ++d) {
    std::transform (points_.begin (), points_.end (), along.begin (), [d] (const auto& point) { return point[d]; });
    const double low = nth (along, outer), high = nth (along, along.size () - 1 - outer);
    centre_[d] = (low + high) / 2;
    half_[d] = (high - low) / 2;
  }
  for (Eigen::Vector3d& point : points_)
    point -= centre_;
}

Eigen::Vector3d
Extent::cameraPlace (const Eigen::Matrix3d& axes, double across, double upward) const
{
  Eigen::Vector3d place (0, 0, 0); // in the camera's axes
  std::vector<double> needed (points_.size ()), slopes (points_.size ());
  const std::size_t outer = points_.size () / outer_share;
  for (int round = 0; round < 10; ++round) { // near points look larger, so the middle of the view depends on the place
    std::transform (points_.begin (), points_.end (), needed.begin (), [&] (const Eigen::Vector3d& point) {
      const Eigen::Vector3d seen = axes.transpose () * point - place;
      return seen.z () + place.z () + std::max (std::abs (seen.x ()) / across, std::abs (seen.y ()) / upward);
    });
    place.z () = std::max (nth (needed, needed.size () - 1 - outer), 1e-6 * half_.norm ());
    for (int d = 0; d < 2; ++d) {
      std::transform (points_.begin (), points_.end (), slopes.begin (), [&] (const Eigen::Vector3d& point) {
        const Eigen::Vector3d seen = axes.transpose () * point - place;
        return seen.z () < 0 ? -seen[d] / seen.z () : 0;
      });
      const double middle = (nth (slopes, outer) + nth (slopes, slopes.size () - 1 - outer)) / 2;
      place[d] += place.z () * middle / 2; // half of it, or near points would overshoot
    }
  }
  return axes * place;
}
} // namespace tools
} // namespace pcl_normal_smoothing
