// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/normal_filter.h>
#include <pcl_normal_smoothing/core/point_update.h>
#include <pcl_normal_smoothing/core/robust_smoothing.h>
#include <pcl_normal_smoothing/core/surface_estimation.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** Everything that smooth () needs to know. */
struct SmoothingOptions
{
  /** In rounds (core/robust_smoothing.h), not as a chain of a normal filter and a point update. */
  bool robust = false;
  NormalSource normals = NormalSource::WPCA;
  HoughOptions hough;
  NormalFilterOptions filter;
  PointUpdateOptions update;
  /** Where noise.sigma, noise.spacing or sheet_distance is below 0 it is estimated; likewise an infinite max_displacement,
    * from sigma. */
  RobustSmoothingOptions rounds;

  /** The same options for positions in another unit: see Positions::unit. What is to be estimated stays so. */
  SmoothingOptions
  inUnit (double unit) const;
};

/** \throw Error where an option is out of range */
void
check (const SmoothingOptions& options);

/** Lets the data tell what smoothing in rounds has to know: which neighbours lie on another sheet, the noise of the cloud,
  * and what follows from it. Nothing changes for the paper's chain.
  * \param[in] normals read only for NormalSource::INPUT
  * \param[in,out] graph on return without neighbours on other sheets
  * \param[in,out] options on return without anything to estimate; given again, they give the same graph */
void
prepareSmoothing (const Positions& positions,
                  const Vectors& normals,
                  const Execution& execution,
                  NeighborGraph::ConstPtr& graph,
                  SmoothingOptions& options);

/** The whole method, Fig. 2 of Valdivia et al. 2013: estimate normals, filter them, move the points to fit them.
  * Or, for options.robust, all of it in rounds.
  * \param[in] options without anything to estimate
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
