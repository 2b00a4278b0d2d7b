// SPDX-License-Identifier: BSD-3-Clause
#include "thinned_sample.h"

#include "../search/hash_sample.h"
#include "../search/thinned_cloud.h"
#include "noise_sample.h"

#include <array>
#include <utility>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
constexpr std::size_t quick_sample_size = 512;
constexpr std::uint32_t row_length = 32;
constexpr std::size_t least_size = 1000; // of the thinnest cloud

Differences
differencesTo (const Positions& nodes, std::uint32_t node, const Row& row)
{
  Differences differences;
  for (std::size_t j = 0; j < row.size (); ++j)
    differences.push_back (nodes.difference (node, row[j]).cast<double> ());
  return differences;
}
} // namespace

std::vector<Differences>
quickSample (const NeighborGraph& graph, const Positions& nodes, const Execution& execution)
{
  std::vector<Differences> differences;
  for (const std::uint32_t node : sampleNodes (nodes, quick_sample_size, execution))
    differences.push_back (differencesTo (nodes, node, graph.row (node)));
  return differences;
}

ThinnedSample::ThinnedSample (const NeighborGraph& graph, const Positions& nodes, const Execution& execution)
: ThinnedSample (graph, nodes, sampleNodes (nodes, noise_sample_size, execution), execution)
{}

ThinnedSample::ThinnedSample (const NeighborGraph& graph,
                              const Positions& nodes,
                              std::vector<std::uint32_t> sample,
                              const Execution& execution)
: graph_ (graph)
, nodes_ (nodes)
, execution_ (execution)
, nodes_of_sample_ (std::move (sample))
, level_count_ (ThinnedCloud::mostHalvings (nodes.size (), least_size) + 1)
{}

std::vector<Differences>
ThinnedSample::differencesAfter (int halvings) const
{
  const ThinnedCloud thinned (graph_, nodes_, halvings, ThinnedCloud::Parts::ONE, execution_);
  std::vector<Differences> differences (size ());
  parallelFor (
      size (), execution_,
      [&] (std::size_t begin, std::size_t end) {
        KdTree::Scratch scratch;
        std::array<std::uint32_t, row_length> row;
        for (std::size_t s = begin; s < end; ++s) {
          thinned.row (nodes_of_sample_[s], row.data (), row_length, scratch);
          differences[s] = differencesTo (nodes_, nodes_of_sample_[s], Row (row.data (), row_length, 1));
        }
      },
      64);
  return differences;
}

std::vector<LocalValue>
ThinnedSample::atPlaces (const std::vector<float>& values) const
{
  std::vector<LocalValue> local;
  for (std::size_t s = 0; s < size (); ++s)
    local.push_back ({nodes_.base[nodes_of_sample_[s]], values[s]});
  return local;
}
} // namespace core
} // namespace pcl_normal_smoothing
