// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/line_estimate.h>
#include <pcl_normal_smoothing/core/thinned_sample.h>

#include <Eigen/Eigenvalues>

#include <algorithm>

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
constexpr double flat = .01;

/** Variances of the nearest along their principal axes, ascending. */
Eigen::Vector3d
spreadOf (const Ways& ways)
{
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect (covarianceOfNearest (ways), Eigen::EigenvaluesOnly);
  return solver.eigenvalues ();
}

/** A first look. */
bool
mayHaveLines (const NeighborGraph& graph, const Positions& nodes, const Execution& execution)
{
  if (graph.minRowLength () < nearest_count)
    return false;
  const std::vector<Ways> sample = quickSample (graph, nodes, execution);
  const auto lines = std::count_if (sample.begin (), sample.end (), [] (const Ways& ways) {
    const Eigen::Vector3d spread = spreadOf (ways);
    return spread[1] < surely_line * spread[2];
  });
  return static_cast<double> (lines) > min_share_of_lines * static_cast<double> (sample.size ());
}

/** Follows a point from all of the cloud to thinner ones. */
class LineEnd
{
public:
  /** \param[in] spread after so many halvings, one more than at the last call */
  void
  see (const Eigen::Vector3d& spread, int halvings)
  {
    if (is_on_line_) {
      halvings_ = halvings;
      is_on_line_ = spread[1] < perhaps_line * spread[2];
    }
    if (is_on_line_ || is_off_plane_)
      return;
    // Noise as wide as the points are close makes a line look like a surface, but one without noise.
    is_off_plane_ = spread[0] >= flat * spread[1];
    if (is_off_plane_)
      halvings_ = halvings;
  }

  float
  halvings () const
  {
    return static_cast<float> (halvings_);
  }

private:
  int halvings_ = 0;
  bool is_on_line_ = true;
  bool is_off_plane_ = false;
};
} // namespace

RegionalField
estimateLines (const NeighborGraph& graph, const Positions& nodes, const Execution& execution)
{
  const Execution silent = execution.silent ();
  if (!mayHaveLines (graph, nodes, silent))
    return {};
  const ThinnedSample sample (graph, nodes, silent);
  std::vector<LineEnd> ends (sample.size ());
  float reach = 0;
  for (int halvings = 0; halvings < sample.end (); ++halvings) {
    const std::vector<Ways> ways = sample.waysAfter (halvings);
    for (std::size_t s = 0; s < ways.size (); ++s)
      ends[s].see (spreadOf (ways[s]), halvings);
    if (halvings == 0)
      reach = medianReach (ways);
  }
  std::vector<float> halvings;
  for (const LineEnd& end : ends)
    halvings.push_back (end.halvings ());
  if (!(reach > 0))
    return {};
  RegionalField field = regionalMedians (sample.inPlace (halvings), reach);
  const auto wide = [] (const RegionalField::Region& region) { return region.value > .5f; };
  return std::any_of (field.regions.begin (), field.regions.end (), wide) ? field : RegionalField ();
}
} // namespace core
} // namespace pcl_normal_smoothing
