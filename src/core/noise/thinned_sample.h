// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "differences.h"
#include "regional_quantiles.h"

#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** The differences to the neighbours of about 512 nodes, as the graph has them, for a quick check. */
std::vector<Differences>
quickSample (const NeighborGraph& graph, const Positions& nodes, const Execution& execution);

/** The neighbourhoods of a sample in the whole cloud, in half of it, a quarter and so on. */
class ThinnedSample
{
public:
  /** \param[in] graph of all nodes, at least one; all arguments kept while this is used */
  ThinnedSample (const NeighborGraph& graph, const Positions& nodes, const Execution& execution);

  /** \param[in] sample the nodes to look at, in the order of what is returned */
  ThinnedSample (const NeighborGraph& graph,
                 const Positions& nodes,
                 std::vector<std::uint32_t> sample,
                 const Execution& execution);

  /** Number of levels of thinning: the cloud as it is, and one for each possible halving. */
  int
  levelCount () const
  {
    return level_count_;
  }

  /** About 4,096. */
  std::size_t
  size () const
  {
    return nodes_of_sample_.size ();
  }

  /** Differences from the points of the sample to the 32 nearest after that number of halvings; padded with zeros. */
  std::vector<Differences>
  differencesAfter (int halvings) const;

  /** The place of a point of the sample. */
  Eigen::Vector3d
  place (std::size_t s) const
  {
    return (nodes_.base[nodes_of_sample_[s]] + nodes_.offset[nodes_of_sample_[s]]).cast<double> ();
  }

  /** \param[in] values one per point of the sample */
  std::vector<LocalValue>
  atPlaces (const std::vector<float>& values) const;

private:
  const NeighborGraph& graph_;
  const Positions& nodes_;
  const Execution& execution_;
  std::vector<std::uint32_t> nodes_of_sample_;
  int level_count_;
};
} // namespace core
} // namespace pcl_normal_smoothing
