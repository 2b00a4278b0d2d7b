// SPDX-License-Identifier: BSD-3-Clause
#include "../quantile.h"
#include "differences.h"

#include "../search/hash_sample.h"
#include "cloud_thickness.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
constexpr std::size_t sample_size = 4096;
constexpr std::size_t part_count = 256;
constexpr std::size_t shares[] = {64, 32}; // a part is 1 / 64 or 1 / 32 of the sample
constexpr std::size_t least_size = 1024;

/** Differences from a node to the nearest points of the sample, in ascending order. */
Differences
nearestDifferences (const Positions& nodes,
                    std::uint32_t node,
                    const std::vector<std::uint32_t>& sample,
                    std::size_t count)
{
  Differences differences;
  differences.reserve (sample.size ());
  for (const std::uint32_t other : sample)
    differences.push_back (nodes.difference (node, other).cast<double> ());
  const auto is_nearer = [] (const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const double a_length = a.squaredNorm (), b_length = b.squaredNorm ();
    return std::tie (a_length, a.x (), a.y (), a.z ()) < std::tie (b_length, b.x (), b.y (), b.z ());
  };
  std::partial_sort (differences.begin (), differences.begin () + static_cast<std::ptrdiff_t> (count),
                     differences.end (), is_nearer);
  differences.resize (count);
  differences.shrink_to_fit ();
  return differences;
}

double
thicknessOf (const Differences& differences, std::size_t count)
{
  const Eigen::Vector3d variances = axesOfNearest (differences, count).variances;
  return variances[1] > 0 ? variances[0] / variances[1] : 0;
}
} // namespace

double
cloudThickness (const Positions& nodes, const Execution& execution)
{
  const std::vector<std::uint32_t> sample = sampleNodes (nodes, sample_size, execution);
  double thickness = std::numeric_limits<double>::infinity ();
  if (sample.size () < least_size)
    return thickness;
  std::vector<std::uint32_t> middles = sampleNodes (nodes, part_count, execution);
  middles.resize (std::min (middles.size (), part_count)); // may be more where many points lie in one place
  std::vector<Differences> parts;
  for (const std::uint32_t node : middles)
    parts.push_back (nearestDifferences (nodes, node, sample, sample.size () / shares[1]));
  for (const std::size_t share : shares) {
    std::vector<float> of_parts;
    for (const Differences& differences : parts)
      of_parts.push_back (static_cast<float> (thicknessOf (differences, sample.size () / share)));
    thickness = std::min<double> (thickness, quantile (of_parts, .5));
  }
  return thickness;
}
} // namespace core
} // namespace pcl_normal_smoothing
