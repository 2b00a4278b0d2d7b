// SPDX-License-Identifier: BSD-3-Clause
#include "thinned_sample.h"

#include <pcl_normal_smoothing/core/noise/line_estimate.h>

#include <algorithm>
#include <cmath>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
// Of the variance along the line, that across it. Of points at random one in fifty comes below the first.
constexpr double surely_line = .1;
constexpr double perhaps_line = .2;
constexpr double min_share_of_lines = .06;
// Of the variance across, that out of the plane: nothing but the line and its noise, which lies in the plane of the scan.
constexpr double surely_flat = .002;
constexpr double perhaps_flat = .01;
constexpr double min_share_flat = .3;
// Between a facet and the surface that it is a part of lie smaller angles than between a scan and a wall.
constexpr double max_cosine_to_surface = .7;

/** How the nearest lie about a node. */
struct Spread
{
  explicit Spread (const Differences& differences) : axes (axesOfNearest (differences)) {}

  bool
  isLine (double share) const
  {
    return axes.variances[1] < share * axes.variances[2]; // across, along
  }

  bool
  isFlat (double share) const
  {
    return axes.variances[0] < share * axes.variances[1]; // out of the plane, across
  }

  PrincipalAxes axes;
};

/** A first look, for clouds with noise. */
bool
mayHaveLines (const NeighborGraph& graph, const Positions& nodes, const Execution& execution)
{
  if (graph.minRowLength () < nearest_count)
    return false;
  std::size_t lines = 0, planes = 0, all = 0;
  for (const Differences& differences : quickSample (graph, nodes, execution)) {
    const Spread spread (differences);
    lines += spread.isLine (surely_line) ? 1 : 0;
    planes += spread.isFlat (surely_flat) ? 1 : 0;
    ++all;
  }
  const auto isShare = [&] (double share, std::size_t count) {
    return static_cast<double> (count) > share * static_cast<double> (all);
  };
  return isShare (min_share_of_lines, lines) || isShare (min_share_flat, planes);
}

/** Follows a point from all of the cloud to thinner ones. */
class LineEnd
{
public:
  /** \param[in] spread after so many halvings, one more than at the last call */
  void
  see (const Spread& spread, int halvings)
  {
    if (is_decided_)
      return;
    if (is_on_line_) {
      is_on_line_ = spread.isLine (perhaps_line);
      halvings_ = halvings;
      if (halvings == 0 && !is_on_line_)
        beginFlat (spread);
    }
    if (!is_on_line_)
      is_decided_ = leavesPlane (spread, halvings);
  }

  float
  halvings () const
  {
    return static_cast<float> (halvings_);
  }

private:
  /** Noise as wide as the points are close makes a line look like a surface, but one without noise. */
  void
  beginFlat (const Spread& spread)
  {
    is_decided_ = !spread.isFlat (surely_flat);
    normal_ = spread.axes.normal;
  }

  /** \return whether it does; so many halvings then show the surface, unless they show the same as before */
  bool
  leavesPlane (const Spread& spread, int halvings)
  {
    if (spread.isFlat (perhaps_flat))
      return false;
    if (std::abs (spread.axes.normal.dot (normal_)) < max_cosine_to_surface)
      halvings_ = halvings;
    return true;
  }

  int halvings_ = 0;
  bool is_on_line_ = true;
  bool is_decided_ = false;
  Eigen::Vector3d normal_ =
      Eigen::Vector3d::Zero (); // of the plane in which a point lies from the start; none of a line
};
} // namespace

RegionalField
estimateLines (const NeighborGraph& graph, const Positions& nodes, const Execution& execution)
{
  const Execution still = execution.still ();
  if (!mayHaveLines (graph, nodes, still))
    return {};
  const ThinnedSample sample (graph, nodes, still);
  std::vector<LineEnd> ends (sample.size ());
  float reach = 0;
  for (int halvings = 0; halvings < sample.levelCount (); ++halvings) {
    const std::vector<Differences> differences = sample.differencesAfter (halvings);
    for (std::size_t s = 0; s < differences.size (); ++s)
      ends[s].see (Spread (differences[s]), halvings);
    if (halvings == 0)
      reach = medianReach (differences);
  }
  std::vector<float> halvings;
  for (const LineEnd& end : ends)
    halvings.push_back (end.halvings ());
  if (!(reach > 0))
    return {};
  RegionalField field = regionalMedians (sample.atPlaces (halvings), reach);
  const auto wide = [] (const RegionalField::Region& region) { return region.value > .5f; };
  return std::any_of (field.regions.begin (), field.regions.end (), wide) ? field : RegionalField ();
}
} // namespace core
} // namespace pcl_normal_smoothing
