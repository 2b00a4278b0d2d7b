// SPDX-License-Identifier: BSD-3-Clause
#include "layer_test.h"
#include "thinned_sample.h"

#include "../search/hash_sample.h"
#include "coordinate_rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
// Of a step: farther from a whole number of them lies no coordinate, however it was rounded.
constexpr double max_rounding = .02;
// Of the step: what rounding makes of sigma, on the large side; and what is nothing.
constexpr float noise_of_rounding = .4f, no_noise = .02f;
constexpr std::size_t step_sample_size = 512;
constexpr double cosine_of_axis = 1 - 1e-5;

/** Of ascending numbers; infinity where they are all the same, 0 where they have none. */
double
stepOf (const std::vector<double>& ascending)
{
  const double first = ascending.front (), extent = ascending.back () - first;
  const double rounding =
      std::numeric_limits<float>::epsilon () * std::max (std::abs (first), std::abs (ascending.back ()));
  double step = extent;
  for (std::size_t i = 1; i < ascending.size (); ++i)
    if (const double difference = ascending[i] - ascending[i - 1]; difference > 2 * rounding)
      step = std::min (step, difference);
  if (!(extent > 2 * rounding))
    return std::numeric_limits<double>::infinity ();
  if (!(rounding < max_rounding / 4 * step))
    return 0;
  for (const double number : ascending) { // the farther from the first, the better it tells the step
    const double steps = std::round ((number - first) / step);
    if (std::abs (number - first - steps * step) > max_rounding * step)
      return 0;
    step = steps > 0 ? (number - first) / steps : step;
  }
  return step;
}

/** Whether steps make layers of the cloud, as for depth cameras. */
bool
showSteps (const ThinnedSample& sample)
{
  double off = 0, stepped = 0;
  for (const Differences& differences : sample.differencesAfter (0))
    if (const auto normal = planeOf (differences); normal && normal->cwiseAbs ().maxCoeff () > cosine_of_axis) {
      const LayerSurrounding surrounding = layerSurrounding (differences, *normal);
      off += surrounding.is_off ? 1 : 0;
      stepped += surrounding.step > 0 ? 1 : 0;
    }
  return off > min_count_off && stepped > min_share_stepped * off;
}
} // namespace

float
CoordinateRounding::atLeast (float sigma) const
{
  return is_seen || sigma > no_noise * step ? std::max (sigma, noise_of_rounding * step) : sigma;
}

double
coordinateStep (const std::vector<Eigen::Vector3d>& places)
{
  double least = std::numeric_limits<double>::infinity ();
  for (int d = 0; d < 3 && !places.empty (); ++d) {
    std::vector<double> numbers;
    for (const Eigen::Vector3d& place : places)
      numbers.push_back (place[d]);
    std::sort (numbers.begin (), numbers.end ());
    least = std::min (least, stepOf (numbers));
  }
  return std::isfinite (least) ? least : 0;
}

CoordinateRounding
estimateRounding (const NeighborGraph& graph, const Positions& nodes, const Execution& execution)
{
  const Execution still = execution.still ();
  std::vector<Eigen::Vector3d> places;
  for (const std::uint32_t node : sampleNodes (nodes, step_sample_size, still))
    places.push_back (nodes.base[node].cast<double> () + nodes.offset[node].cast<double> ());
  const auto step = static_cast<float> (coordinateStep (places));
  return {step, step > 0 && graph.minRowLength () >= nearest_count && showSteps (ThinnedSample (graph, nodes, still))};
}
} // namespace core
} // namespace pcl_normal_smoothing
