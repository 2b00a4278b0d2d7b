// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/kd_tree.h>
#include <pcl_normal_smoothing/core/node_blocks.h>
#include <pcl_normal_smoothing/core/noise_estimate.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
constexpr std::size_t sample_size = 4096;
constexpr std::uint32_t row_length = noise_row_length;
constexpr double pi = 3.14159265358979;

std::uint32_t
hashOf (const Eigen::Vector3f& point)
{
  std::uint32_t hash = 2166136261u;
  for (int d = 0; d < 3; ++d) {
    const float coordinate = point[d] + 0.0f; // -0 is 0
    std::uint32_t bits;
    std::memcpy (&bits, &coordinate, sizeof bits);
    hash = (hash ^ bits) * 0x9E3779B1u;
    hash = (hash ^ (hash >> 15)) * 0x85EBCA77u;
    hash ^= hash >> 13;
  }
  return hash;
}

/** The neighbourhoods of the nodes in a sample, one after the other, each filled up with the node itself. */
using SampleRows = std::vector<std::uint32_t>;

SampleRows
rowsOfGraph (const NeighborGraph& graph, const std::vector<std::uint32_t>& sample)
{
  SampleRows rows;
  rows.reserve (sample.size () * row_length);
  for (const std::uint32_t node : sample) {
    const Row row = graph.row (node);
    for (std::size_t j = 0; j < row_length; ++j)
      rows.push_back (j < row.size () ? row[j] : node);
  }
  return rows;
}

/** As a graph of all would have them, which takes longer and more memory. */
SampleRows
searchedRows (const NeighborGraph& graph,
              const Positions& nodes,
              const std::vector<std::uint32_t>& sample,
              const Execution& execution)
{
  const KdTree tree (nodes, graph.order (), execution.silent ());
  SampleRows rows (sample.size () * row_length);
  parallelFor (
      sample.size (), execution,
      [&] (std::size_t begin, std::size_t end) {
        KdTree::Scratch scratch;
        for (std::size_t i = begin; i < end; ++i) {
          const std::uint32_t node = sample[i];
          const auto row = rows.begin () + static_cast<std::ptrdiff_t> (i * row_length);
          std::fill_n (row, row_length, node);
          auto place = row + 1;
          for (const Neighbor& neighbor : tree.search (nodes.base[node], nodes.offset[node], {row_length}, scratch))
            if (tree.order ()[neighbor.slot] != node && place != row + row_length)
              *place++ = tree.order ()[neighbor.slot];
        }
      },
      64);
  return rows;
}

/** The rows of 16 nodes side by side, as a graph keeps those of a block. */
std::vector<std::uint32_t>
blockOf (const SampleRows& rows, std::size_t begin)
{
  std::vector<std::uint32_t> block (row_length * NeighborGraph::block_size);
  for (std::size_t lane = 0; lane < NeighborGraph::block_size; ++lane) {
    const std::size_t first = std::min ((begin + lane) * row_length, rows.size () - row_length);
    for (std::size_t j = 0; j < row_length; ++j)
      block[j * NeighborGraph::block_size + lane] = rows[first + j];
  }
  return block;
}

NoiseSample
residualsOf (const Positions& nodes,
             const std::vector<std::uint32_t>& sample,
             const SampleRows& rows,
             const Execution& execution)
{
  constexpr std::array<std::size_t, 3> sizes = {8, 12, 16};
  std::array<Numbers, 3> of_nodes;
  for (auto& variances : of_nodes)
    variances.resize (nodes.size ());
  const NodeArrays arrays = nodeArrays (nodes, nodes.base);
  const std::size_t block_count = (sample.size () + NeighborGraph::block_size - 1) / NeighborGraph::block_size;
  parallelFor (
      block_count, execution,
      [&] (std::size_t begin, std::size_t end) {
        for (std::size_t block = begin; block < end; ++block) {
          const auto block_rows = blockOf (rows, block * NeighborGraph::block_size);
          for (std::size_t i = 0; i < sizes.size (); ++i)
            kernels ().residual_variances ({arrays, of_nodes[i].data ()}, {block_rows.data (), sizes[i]});
        }
      },
      8);

  NoiseSample residuals;
  for (std::size_t s = 0; s < sample.size (); ++s) {
    const std::uint32_t node = sample[s], eighth = rows[s * row_length + sizes[0] - 1];
    residuals.of_nodes.push_back ({{of_nodes[0][node], of_nodes[1][node], of_nodes[2][node]},
                                   eighth == node ? 0 : nodes.difference (node, eighth).norm ()});
  }
  return residuals;
}

double
quantile (std::vector<float> values, double share)
{
  if (values.empty ())
    return 0;
  const auto at = values.begin () + static_cast<std::ptrdiff_t> (share * static_cast<double> (values.size ()));
  std::nth_element (values.begin (), at, values.end ());
  return *at;
}

/** The variance at no size of neighbourhood, from those at a small and a large one: curvature adds to the larger more. But
  * where it is many times the smaller, the neighbourhoods do not fit a quadric, and the difference tells nothing. */
double
extrapolated (double small, double large, double slope, double largest_excess)
{
  const double excess = std::max (0.0, large - small);
  const double trust = std::clamp (2 - excess / (largest_excess * small + 1e-30), 0.0, 1.0);
  return std::max (small - slope * trust * excess, 0.2 * small);
}
/** Coordinates in steps as large as the noise (depth cameras): the eight nearest points often lie in one plane exactly, and
  * show far less than the larger neighbourhoods, which agree. Curvature makes them differ too. */
bool
isQuantised (double of_8, double of_12, double of_16)
{
  return of_12 > 5 * of_8 && of_16 < 1.3 * of_12;
}

double
spacingOf (double distance_of_eighth)
{
  return distance_of_eighth * std::sqrt (pi / 8);
}

/** A quadric follows the more of the noise the larger it is against the spacing: a factor of sigma.
  * \param[in] ratio of sigma, as it is read, to the spacing */
double
whatQuadricsFollow (double ratio)
{
  return 1 + .3 * ratio + 1.2 * ratio * ratio;
}

/** How much too small quadrics make the noise look, by the ratio of the sigma that there is: of a point, not of the usual one, and
  * on the large side. */
double
whatDensityHides (double ratio)
{
  const double bounded = std::min (ratio, 10.0); // nearly copies
  return std::sqrt (1 + 2.2 * bounded * bounded);
}

/** \param[in] factor (distance of the eighth): of sigma where the points are as dense */
template <typename Factor>
double
sigmaBy (const NoiseSample& sample, const Factor& factor)
{
  std::array<std::vector<float>, 3> variances;
  for (const NoiseSample::Residuals& residuals : sample.of_nodes)
    for (std::size_t i = 0; i < variances.size (); ++i)
      if (std::isfinite (residuals.variances[i])) {
        const double f = residuals.distance > 0 ? factor (residuals.distance) : 1; // copies of a point have no density
        variances[i].push_back (static_cast<float> (f * f * residuals.variances[i]));
      }
  const auto& [of_8, of_12, of_16] = variances;
  // Quantiles over those of chi-square by its 2, 6 and 10 degrees of freedom. Edges spoil the upper ones, other sheets all
  // but the lower ones.
  const double lower_12 = quantile (of_12, .25) / .5758, lower_16 = quantile (of_16, .25) / .6737;
  double lower_8 = quantile (of_8, .25) / .2877;
  if (isQuantised (lower_8, lower_12, lower_16))
    lower_8 = lower_12;
  const double lower = extrapolated (lower_8, lower_12, .3, 2.5), lowest = extrapolated (lower_8, lower_12, .9, 2.5);
  const double median = extrapolated (quantile (of_8, .5) / .6931, quantile (of_12, .5) / .891, .3, 2.5);
  const double upper = extrapolated (quantile (of_8, .75) / 1.3863, quantile (of_16, .75) / 1.2549, .4, 3);
  return std::sqrt (std::min ({1.1 * lower, 1.05 * median, std::max (upper, .75 * lowest)}));
}
} // namespace

std::vector<std::uint32_t>
sampleNodes (const Positions& nodes, std::uint64_t cloud_size, std::size_t sample_size, const Execution& execution)
{
  const double share =
      static_cast<double> (sample_size) / static_cast<double> (std::max<std::uint64_t> (cloud_size, sample_size));
  const auto limit = static_cast<std::uint32_t> (share * 4294967295.0);
  constexpr std::size_t part_size = 1 << 16;
  std::vector<std::vector<std::uint32_t>> parts (nodes.size () / part_size + 1);
  const auto find = [&] (std::size_t begin, std::size_t end) {
    for (std::size_t node = begin * part_size; node < std::min (end * part_size, nodes.size ()); ++node)
      if (hashOf (nodes.base[node]) <= limit)
        parts[node / part_size].push_back (static_cast<std::uint32_t> (node));
  };
  parallelFor (parts.size (), execution.silent (), find, 1);
  std::vector<std::uint32_t> sample;
  for (const auto& part : parts)
    sample.insert (sample.end (), part.begin (), part.end ());
  return sample;
}

void
NoiseSample::join (const NoiseSample& part)
{
  of_nodes.insert (of_nodes.end (), part.of_nodes.begin (), part.of_nodes.end ());
  short_rows += part.short_rows;
}

std::vector<std::uint32_t>
noiseSampleNodes (const Positions& nodes, std::uint64_t cloud_size)
{
  return sampleNodes (nodes, cloud_size, sample_size, Execution (1));
}

NoiseSample
sampleNoise (const NeighborGraph& graph,
             const Positions& nodes,
             const std::vector<std::uint32_t>& sample,
             std::uint64_t cloud_size,
             const Execution& execution)
{
  std::vector<std::uint32_t> with_rows;
  for (const std::uint32_t node : sample)
    if (graph.row (node).size () >= std::min<std::uint64_t> (row_length, cloud_size))
      with_rows.push_back (node);
  NoiseSample residuals = residualsOf (nodes, with_rows, rowsOfGraph (graph, with_rows), execution);
  residuals.short_rows = sample.size () - with_rows.size ();
  return residuals;
}

NoiseEstimate
estimateNoise (const NeighborGraph& graph, const Positions& nodes, const Execution& execution)
{
  const std::vector<std::uint32_t> sample = sampleNodes (nodes, nodes.size (), sample_size, execution);
  // A graph by radius, or of small neighbourhoods, does not show enough.
  const bool is_enough = graph.minRowLength () >= std::min<std::size_t> (row_length, graph.size ());
  if (is_enough)
    return estimateNoise (sampleNoise (graph, nodes, sample, nodes.size (), execution));
  return estimateNoise (residualsOf (nodes, sample, searchedRows (graph, nodes, sample, execution), execution));
}

NoiseEstimate
estimateNoise (const NoiseSample& sample)
{
  std::vector<float> distances;
  for (const NoiseSample::Residuals& residuals : sample.of_nodes)
    if (residuals.distance > 0)
      distances.push_back (residuals.distance);
  const double spacing = spacingOf (quantile (distances, .5));
  if (!(spacing > 0) || sample.short_rows > 3 * sample.of_nodes.size ())
    return {};
  double sigma = sigmaBy (sample, [] (float) { return 1; });
  for (int iteration = 0; iteration < 2; ++iteration) {
    const double known = sigma * whatQuadricsFollow (sigma / spacing), usual = whatDensityHides (known / spacing);
    sigma = sigmaBy (sample, [&] (float distance) { return whatDensityHides (known / spacingOf (distance)) / usual; });
  }
  return {static_cast<float> (sigma * whatQuadricsFollow (sigma / spacing)), static_cast<float> (spacing)};
}
} // namespace core
} // namespace pcl_normal_smoothing
