// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "differences.h"

#include <pcl_normal_smoothing/core/noise/regional_field.h>
#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** The neighbours of about 512 nodes, as the graph has them: a first look, which is cheap. */
std::vector<Differences>
quickSample (const NeighborGraph& graph, const Positions& nodes, const Execution& execution);

/** What neighbourhoods as they are, and wider ones, show at a sample of a cloud: the nearest in all of it, in half of
  * it, a quarter ... */
class ThinnedSample
{
public:
  /** \param[in] graph of all nodes, at least one; all kept while this is used */
  ThinnedSample (const NeighborGraph& graph, const Positions& nodes, const Execution& execution);

  /** The levels of thinning: the cloud as it is, and as often as it can be halved. */
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

  /** From the points of the sample to the 32 nearest where so many halvings thin the cloud; filled up with zeros. */
  std::vector<Differences>
  differencesAfter (int halvings) const;

  /** Of a point of the sample. */
  Eigen::Vector3d
  place (std::size_t s) const
  {
    return (nodes_.base[nodes_of_sample_[s]] + nodes_.offset[nodes_of_sample_[s]]).cast<double> ();
  }

  /** \param[in] values one for every point of the sample */
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
