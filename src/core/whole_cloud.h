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
  * \param[in] execution progress stands still meanwhile
  * \param[in,out] graph on return with neighbourhoods that see past layers and noise, and without neighbours on other
  * sheets
  * \param[in,out] options that pass check; on return without anything to estimate, and widening neighbourhoods where
  * these had to be; given again, they give the same graph and positions
  * \param[in,out] surface its normals are read only for NormalSource::INPUT; where the noise is wider than the spacing
  * its positions change: see core/noise/quadric_projection.h */
void
prepareSmoothing (const Execution& execution,
                  NeighborGraph::ConstPtr& graph,
                  SmoothingOptions& options,
                  MovingSurface& surface);
} // namespace core
} // namespace pcl_normal_smoothing
