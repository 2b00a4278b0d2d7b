// SPDX-License-Identifier: BSD-3-Clause
#include "../quantile.h"

#include "quadric_projection.h"

#include "../search/node_blocks.h"
#include "../search/thinned_cloud.h"
#include "wide_noise.h"

#include <algorithm>
#include <cmath>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
// Number of neighbours per ratio of sigma to the spacing: 3.2 sigma are within reach at a ratio of 1, 2.1 at 2.3.
constexpr float neighbors_of_ratio = 32;
constexpr long least_neighbors = 32;
// Share of sigma left by a projection; and the ratio above which another one is worth the detail it costs.
constexpr float noise_left = .6f;
constexpr float ratio_to_repeat = 1.2f;

/** \param[in] ratio of sigma to the spacing
  * \return how many neighbours show the surface; 0 if those of the rounds do */
std::uint32_t
neighborCount (float ratio)
{
  if (!(ratio >= least_ratio_to_project))
    return 0;
  return static_cast<std::uint32_t> (std::clamp (std::lround (neighbors_of_ratio * ratio), least_neighbors,
                                                 static_cast<long> (max_projection_neighbors)));
}

/** Neighbourhoods in the whole cloud, for one block of nodes at a time. */
class BlocksInCloud
{
public:
  BlocksInCloud (const NeighborGraph& graph, const Positions& nodes, const Execution& execution)
  : cloud_ (graph, nodes, 0, ThinnedCloud::Parts::ONE, execution), size_ (nodes.size ())
  {}

  struct Scratch
  {
    KdTree::Scratch of_search;
    std::vector<std::uint32_t> counts, row, neighbors;
  };

  /** \param[in] countOf gives the number of neighbours of a node, itself included, or 0
    * \return valid until \a scratch is used again */
  template <typename CountOf>
  BlockRows
  rows (std::size_t block, const CountOf& countOf, Scratch& scratch) const
  {
    constexpr std::size_t lanes = block_size;
    const auto nodeOf = [&] (std::size_t lane) {
      return static_cast<std::uint32_t> (std::min (block * lanes + lane, size_ - 1));
    };
    scratch.counts.clear ();
    for (std::size_t lane = 0; lane < lanes; ++lane)
      scratch.counts.push_back (countOf (nodeOf (lane)));
    const std::size_t length = std::max (1u, *std::max_element (scratch.counts.begin (), scratch.counts.end ()));
    scratch.neighbors.resize (lanes * length);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      scratch.row.assign (length, nodeOf (lane));
      if (scratch.counts[lane] > 0)
        cloud_.row (nodeOf (lane), scratch.row.data (), scratch.counts[lane], scratch.of_search);
      for (std::size_t j = 0; j < length; ++j)
        scratch.neighbors[lanes * j + lane] = scratch.row[j];
    }
    return {scratch.neighbors.data (), length};
  }

private:
  ThinnedCloud cloud_;
  std::size_t size_;
};

/** \param[in] left share of the noise left by previous projections */
void
projectOnce (const NeighborGraph& graph,
             const RegionalField& ratios,
             float left,
             const Execution& execution,
             Positions& nodes)
{
  const BlocksInCloud blocks (graph, nodes, execution);
  const auto countOf = [&] (std::uint32_t node) { return neighborCount (left * ratios.valueAt (nodes.base[node], 0)); };
  Vectors projected (nodes.size ());
  const QuadricProjection projection {nodeArrays (nodes), projected.data ()->data ()};
  parallelFor (graph.blockCount (), execution, [&] (std::size_t begin, std::size_t end) {
    BlocksInCloud::Scratch scratch;
    for (std::size_t block = begin; block < end; ++block)
      kernels ().project_points (projection, blocks.rows (block, countOf, scratch));
  });
  nodes.offset.swap (projected);
}
} // namespace

void
projectOntoQuadrics (const NeighborGraph& graph,
                     const RegionalField& ratios,
                     const Execution& execution,
                     Positions& nodes)
{
  std::vector<float> of_regions = ratios.values ();
  const float usual = quantile (of_regions, .5);
  float left = 1;
  do {
    projectOnce (graph, ratios, left, execution, nodes);
    left *= noise_left;
  } while (left * usual > ratio_to_repeat);
}
} // namespace core
} // namespace pcl_normal_smoothing
