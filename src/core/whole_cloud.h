// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/smoothing.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** Estimates from the data what smoothing in rounds needs: the layers that neighbourhoods must see past, the neighbours
  * on other sheets, the noise, and what follows from it. Changes nothing for the paper's chain.
  * \param[in] execution progress stands still meanwhile
  * \param[in,out] graph on return with neighbourhoods that see past layers and noise, without neighbours on other
  * sheets
  * \param[in,out] options that pass check; on return nothing is left to estimate, and widen_neighborhoods is set if
  * neighbourhoods had to grow; given again, they give the same graph and positions
  * \param[in,out] surface its normals are read only for NormalSource::INPUT; where the noise is wider than the
  * spacing its positions change: see core/noise/quadric_projection.h */
void
prepareSmoothing (const Execution& execution,
                  NeighborGraph::ConstPtr& graph,
                  SmoothingOptions& options,
                  MovingSurface& surface);
} // namespace core
} // namespace pcl_normal_smoothing
