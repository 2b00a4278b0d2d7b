// SPDX-License-Identifier: BSD-3-Clause
#include "thinned_sample.h"

#include "line_estimate.h"
#include "line_noise.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
// Upper bounds on the variance across a line over that along it. Points at random are below the first once in fifty.
constexpr double surely_line = .1;
constexpr double perhaps_line = .2;
constexpr double min_share_of_lines = .06;
// Upper bounds on the variance out of the plane over that across: a line and its noise alone lie in the plane of the
// scan.
constexpr double surely_flat = .002;
constexpr double perhaps_flat = .01;
constexpr double min_share_flat = .3;
// A facet meets the surface that it belongs to at smaller angles than a scan plane meets a wall.
constexpr double max_cosine_to_surface = .7;

// Lines that meet the surface at 30 degrees or more are rays on which several frames have a point each: their noise is
// along them. Of a scanner's lines 5 % look like rays, of those where frames overlap 20 % and more.
constexpr double max_cosine_to_line = .5;
constexpr double max_share_of_rays = .1;
// Below this share of points on lines, lines are chance. Points on lines by chance are straighter than others, but not
// straighter than \a straight times the distance to the eighth neighbour.
constexpr double min_share_on_lines = .2;
constexpr double straight = 1e-3;
// Upper bound on sigma over the noise that lines show; a slight overestimate does no harm.
constexpr double most_of_noise_along = 1.2;

/** The spread of the nearest points about a node. */
struct Spread
{
  explicit Spread (const Differences& differences) : axes (axesOfNearest (differences)) {}

  bool
  isFlat (double share) const
  {
    return axes.variances[0] < share * axes.variances[1]; // out of the plane against across
  }

  PrincipalAxes axes;
};

/** A quick check, which is all that most clouds need. */
bool
mayHaveLines (const NeighborGraph& graph, const Positions& nodes, const Execution& execution)
{
  if (graph.minRowLength () < nearest_count)
    return false;
  std::size_t lines = 0, planes = 0, all = 0;
  for (const Differences& differences : quickSample (graph, nodes, execution)) {
    const Spread spread (differences);
    lines += spread.axes.areLine (surely_line) ? 1 : 0;
    planes += spread.isFlat (surely_flat) ? 1 : 0;
    ++all;
  }
  const auto isShare = [&] (double share, std::size_t count) {
    return static_cast<double> (count) > share * static_cast<double> (all);
  };
  return isShare (min_share_of_lines, lines) || isShare (min_share_flat, planes);
}

/** A point seen in the whole cloud, then in thinner and thinner ones, until its nearest show the surface. */
class ThinnedPoint
{
public:
  /** \param[in] spread after \a halvings, which grow by one with every call */
  void
  see (const Spread& spread, int halvings)
  {
    if (halvings == 0) {
      direction_ = spread.axes.direction;
      is_thin_ = spread.axes.areLine (perhaps_line);
    }
    if (is_decided_)
      return;
    if (is_on_line_) {
      is_on_line_ = spread.axes.areLine (perhaps_line);
      halvings_ = halvings;
      if (halvings == 0 && !is_on_line_)
        beginFlat (spread);
    }
    if (!is_on_line_)
      is_decided_ = leavesPlane (spread, halvings);
    surface_ = spread.axes.normal;
  }

  float
  halvings () const
  {
    return static_cast<float> (halvings_);
  }

  /** Whether the line is one in the whole cloud already, with noise narrower than its points are apart. */
  bool
  isThin () const
  {
    return is_thin_;
  }

  /** Whether the line lies in the surface, and is not a ray. */
  bool
  isInSurface () const
  {
    return std::abs (direction_.dot (surface_)) < max_cosine_to_line;
  }

private:
  /** Noise as wide as the spacing along a line makes it look like a surface, but a flat one. */
  void
  beginFlat (const Spread& spread)
  {
    is_decided_ = !spread.isFlat (surely_flat);
    normal_ = spread.axes.normal;
  }

  /** \return whether the nearest leave the plane; these halvings then show the surface, unless that is the plane
    * itself */
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
  Eigen::Vector3d direction_; // of the nearest in the whole cloud
  Eigen::Vector3d surface_;   // its normal after the last halving considered
  bool is_thin_ = false;
  bool is_on_line_ = true;
  bool is_decided_ = false;
  Eigen::Vector3d normal_ = Eigen::Vector3d::Zero (); // of the plane of the nearest in the whole cloud; zero for a line
};

/** An upper bound on sigma from the noise along lines; infinity if they do not show it.
  * \param[in] unthinned, points of the same nodes
  * \param[in] reach median distance of the eighth nearest */
float
mostSigma (const std::vector<Differences>& unthinned, const std::vector<ThinnedPoint>& points, float reach)
{
  std::vector<Differences> on_lines;
  std::size_t thin = 0, rays = 0;
  for (std::size_t s = 0; s < points.size (); ++s) {
    if (!(points[s].halvings () > 0))
      continue;
    on_lines.push_back (unthinned[s]);
    if (!points[s].isThin ())
      continue;
    thin += 1;
    rays += points[s].isInSurface () ? 0 : 1;
  }
  if (static_cast<double> (rays) > max_share_of_rays * static_cast<double> (thin))
    return std::numeric_limits<float>::infinity ();
  const double noise = noiseAlongLines (on_lines);
  const bool by_chance =
      static_cast<double> (on_lines.size ()) < min_share_on_lines * static_cast<double> (points.size ()) &&
      noise > straight * reach;
  return by_chance ? std::numeric_limits<float>::infinity () : static_cast<float> (most_of_noise_along * noise);
}
} // namespace

LineEstimate
estimateLines (const NeighborGraph& graph, const Positions& nodes, const Execution& execution)
{
  const Execution still = execution.still ();
  if (!mayHaveLines (graph, nodes, still))
    return {};
  const ThinnedSample sample (graph, nodes, still);
  std::vector<ThinnedPoint> points (sample.size ());
  float reach = 0;
  std::vector<Differences> unthinned;
  for (int halvings = 0; halvings < sample.levelCount (); ++halvings) {
    const std::vector<Differences> differences = sample.differencesAfter (halvings);
    for (std::size_t s = 0; s < differences.size (); ++s)
      points[s].see (Spread (differences[s]), halvings);
    if (halvings == 0) {
      reach = medianReach (differences);
      unthinned = differences;
    }
  }
  std::vector<float> halvings;
  for (const ThinnedPoint& point : points)
    halvings.push_back (point.halvings ());
  if (!(reach > 0))
    return {};
  RegionalField field = regionalMedians (sample.atPlaces (halvings), reach);
  const auto wide = [] (const RegionalField::Region& region) { return region.value > .5f; };
  if (std::none_of (field.regions.begin (), field.regions.end (), wide))
    return {};
  return {std::move (field), mostSigma (unthinned, points, reach)};
}
} // namespace core
} // namespace pcl_normal_smoothing
