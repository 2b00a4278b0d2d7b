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
// Upper bound on a coordinate's deviation from a whole number of steps, in steps.
constexpr double max_rounding = .02;
// In steps: sigma of rounding, on the large side; and the sigma up to which there is no noise.
constexpr float noise_of_rounding = .4f, no_noise = .02f;
constexpr std::size_t step_sample_size = 512;
constexpr double cosine_of_axis = 1 - 1e-5;

/** The step of ascending numbers; infinity if all are equal, 0 if they have none. */
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
  for (const double number : ascending) { // numbers farther from the first determine the step more accurately
    const double steps = std::round ((number - first) / step);
    if (std::abs (number - first - steps * step) > max_rounding * step)
      return 0;
    step = steps > 0 ? (number - first) / steps : step;
  }
  return step;
}

/** Whether the steps form layers in the cloud, as those of depth cameras do. */
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
