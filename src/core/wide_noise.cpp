// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/hash_sample.h>
#include <pcl_normal_smoothing/core/noise_estimate.h>
#include <pcl_normal_smoothing/core/sheet_estimate.h>
#include <pcl_normal_smoothing/core/thinned_cloud.h>
#include <pcl_normal_smoothing/core/thinned_sample.h>
#include <pcl_normal_smoothing/core/wide_noise.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
// Of sigma to the spacing, as they are read. Up to the first, nothing is hidden but in clumps (below), and neighbourhoods that have to be
// wider had better be that wide; up to the second, evenly sampled surfaces are still read and smoothed as they are.
constexpr double read_surely = .3;
constexpr double read_if_even = .85;
// A halving makes the spacing 1.4 times as wide, and the ratio .71 of what it was, two halvings .5; where a part of the noise is hidden,
// more of it shows.
constexpr double max_fall = .83;
constexpr double max_fall_of_two = .7;
// Where points lie in clumps, as where sweeps of a lidar cross, noise hides in these, and the usual spacing is that of others: less is read.
// There planes through few points are not those through more, and the ratio hardly falls. In small clouds detail does the same; so
// a quarter of the cloud has to be a whole sample.
constexpr double read_in_clumps = .1;
constexpr double max_fall_in_clumps = .92;
constexpr std::size_t least_to_quarter = 4 * noise_sample_size;
constexpr double min_share_turned = .06;
constexpr double max_cosine_turned = .7;
constexpr double spacing_of_reach = .6267; // of the eighth point, as in the estimate of the noise: sqrt (pi / 8)

double
ratioOf (const NoiseSample& sample)
{
  const NoiseEstimate noise = estimateNoise (sample);
  return noise.spacing > 0 ? noise.sigma / noise.spacing : 0;
}

Eigen::Vector3d
planeNormal (const Ways& ways, std::size_t count)
{
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  return solver.computeDirect (covarianceOfNearest (ways, count)).eigenvectors ().col (0);
}

/** Whether planes through the nearest half of a neighbourhood often are others than those through all of it: where it is a ball or a
  * ribbon inside the noise. */
bool
planesTurn (const NeighborGraph& graph, const Positions& nodes, const Execution& execution)
{
  std::size_t turned = 0, all = 0;
  for (const Ways& ways : quickSample (graph, nodes, execution)) {
    const double cosine = planeNormal (ways, noise_row_length / 2).dot (planeNormal (ways, noise_row_length));
    turned += std::abs (cosine) < max_cosine_turned ? 1 : 0;
    ++all;
  }
  return static_cast<double> (turned) > min_share_turned * static_cast<double> (all);
}

/** The noise as neighbourhoods in a thinner cloud show it. */
class ThinnedNoise
{
public:
  ThinnedNoise (const NeighborGraph& graph, const Positions& nodes, const Execution& execution)
  : graph_ (graph), nodes_ (nodes), execution_ (execution), sample_ (sampleNodes (nodes, noise_sample_size, execution))
  {}

  NoiseSample
  after (int halvings) const
  {
    const auto length = static_cast<std::uint32_t> (graph_.minRowLength ());
    if (halvings == 0 || sample_.empty ())
      return sampleNoise (graph_, nodes_, sample_, nodes_.size (), execution_);
    const ThinnedCloud thinned (graph_, nodes_, halvings, ThinnedCloud::Parts::ONE, execution_);
    std::vector<std::uint32_t> rows (sample_.size () * length);
    KdTree::Scratch scratch;
    for (std::size_t s = 0; s < sample_.size (); ++s)
      thinned.row (sample_[s], rows.data () + s * length, length, scratch);
    return sampleNoise (*graph_.withRows (sample_, rows, length), nodes_, sample_, nodes_.size (), execution_);
  }

  /** Of sigma to the spacing. */
  double
  ratio (int halvings)
  {
    while (ratios_.size () <= static_cast<std::size_t> (halvings))
      ratios_.push_back (ratioOf (after (static_cast<int> (ratios_.size ()))));
    return ratios_[static_cast<std::size_t> (halvings)];
  }

  bool
  canBeQuartered () const
  {
    return nodes_.size () >= least_to_quarter;
  }

  bool
  hasTurningPlanes () const
  {
    return planesTurn (graph_, nodes_, execution_);
  }

private:
  const NeighborGraph& graph_;
  const Positions& nodes_;
  const Execution& execution_;
  std::vector<std::uint32_t> sample_;
  std::vector<double> ratios_;
};

bool
hidesNoise (ThinnedNoise& noise)
{
  const double ratio = noise.ratio (0);
  const auto fallsBelow = [&] (double share, int halvings) { return noise.ratio (halvings) < share * ratio; };
  if (ratio > read_surely)
    return ratio >= read_if_even || !fallsBelow (max_fall, 1) ||
           (noise.canBeQuartered () && !fallsBelow (max_fall_of_two, 2));
  return ratio > read_in_clumps && noise.canBeQuartered () && noise.hasTurningPlanes () &&
         (!fallsBelow (max_fall_in_clumps, 1) || !fallsBelow (max_fall_of_two, 2));
}

/** \return how often the cloud has to be halved, as a whole; 0 where it need not be, or where no surface is seen however often: leaves
  * and grass stay as they are */
int
halvingsOf (ThinnedNoise& noise, int most)
{
  if (most == 0 || !hidesNoise (noise))
    return 0;
  for (int halvings = 1; halvings < most; ++halvings)
    if (noise.ratio (halvings) < read_surely && noise.ratio (halvings + 1) < max_fall * noise.ratio (halvings))
      return halvings;
  return noise.ratio (0) > read_surely && noise.ratio (most) < read_surely ? most : 0;
}

/** Close sheets look like wide noise. */
bool
showsSheets (const NeighborGraph& graph, const Positions& nodes, const NoiseEstimate& noise, const Execution& execution)
{
  return estimateSheets (graph, nodes, std::min (4 * noise.sigma, 1.2f * noise.spacing), execution).gap > 0;
}
} // namespace

RegionalField
estimateWideNoise (const NeighborGraph& graph, const Positions& nodes, const Execution& execution)
{
  if (graph.minRowLength () < noise_row_length)
    return {};
  const Execution still = execution.still ();
  ThinnedNoise thinned (graph, nodes, still);
  const int halvings = halvingsOf (thinned, ThinnedCloud::mostHalvings (nodes.size (), ThinnedCloud::least_size));
  if (halvings == 0 || showsSheets (graph, nodes, estimateNoise (thinned.after (0)), still))
    return {};
  const NoiseSample sample = thinned.after (halvings);
  const NoiseEstimate noise = estimateNoise (sample);
  std::vector<LocalValue> local;
  for (const NoiseSample::Residuals& residuals : sample.of_nodes) {
    // Where points lie closer, or there is more noise, they have to be halved more often.
    const double denser =
        noise.spacing / std::max<double> (spacing_of_reach * residuals.distance, 1e-3 * noise.spacing);
    const double of_place = halvings + 2 * std::log2 (denser * noise.field.factorAt (residuals.place));
    local.push_back ({residuals.place, static_cast<float> (std::max (0.0, of_place))});
  }
  return regionalMedians (local, noise.spacing);
}
} // namespace core
} // namespace pcl_normal_smoothing
