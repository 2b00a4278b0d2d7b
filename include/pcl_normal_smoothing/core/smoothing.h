// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/normal_filter.h>
#include <pcl_normal_smoothing/core/point_update.h>
#include <pcl_normal_smoothing/core/surface_estimation.h>

namespace pcl_normal_smoothing
{
namespace core
{
struct SmoothingOptions
{
  NormalSource normals = NormalSource::WPCA;
  HoughOptions hough;
  NormalFilterOptions filter;
  PointUpdateOptions update;
};

/** The whole method, Fig. 2 of Valdivia et al. 2013: estimate normals, filter them, move the points to fit them.
  * \param[in,out] positions of the nodes; their offsets change
  * \param[in,out] normals of the nodes; read only for NormalSource::INPUT; on return those that the points fit
  * \throw Error where no node has a normal */
void
smooth (const NeighborGraph::ConstPtr& graph,
        const SmoothingOptions& options,
        const Research& research,
        const Execution& execution,
        Positions& positions,
        Vectors& normals);
} // namespace core
} // namespace pcl_normal_smoothing
