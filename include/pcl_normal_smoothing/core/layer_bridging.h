// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/layer_estimate.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** Gives every node as many neighbours as it has, but so far apart that most see more than one layer.
  * \return null where rows stay as they are: there are no layers, or the rows differ in length, for whoever bounds neighbourhoods
  * by a radius means it */
NeighborGraph::Ptr
bridgeLayers (const NeighborGraph& graph,
              const Positions& nodes,
              const LayerEstimate& layers,
              const Execution& execution);
} // namespace core
} // namespace pcl_normal_smoothing
