// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/smoothing.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** Lets the data tell what smoothing in rounds has to know: the layers that neighbourhoods must see past, which
  * neighbours lie on another sheet, the noise of the cloud, and what follows from it. Nothing changes for the paper's
  * chain.
  * \param[in] normals read only for NormalSource::INPUT
  * \param[in] execution progress stands still meanwhile
  * \param[in,out] graph on return with neighbourhoods that see past layers and noise, and without neighbours on other
  * sheets
  * \param[in,out] options that pass check; on return without anything to estimate, and widening neighbourhoods where
  * these had to be; given again, they give the same graph and positions
  * \param[in,out] positions of the nodes; where the noise is wider than the spacing their offsets change: see
  * core/noise/quadric_projection.h */
void
prepareSmoothing (const Vectors& normals,
                  const Execution& execution,
                  NeighborGraph::ConstPtr& graph,
                  SmoothingOptions& options,
                  Positions& positions);
} // namespace core
} // namespace pcl_normal_smoothing
