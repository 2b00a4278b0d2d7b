// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/chain/normal_filter.h>
#include <pcl_normal_smoothing/core/chain/point_update.h>
#include <pcl_normal_smoothing/core/chain/surface_estimation.h>
#include <pcl_normal_smoothing/core/rounds/robust_smoothing.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** Everything that smooth () needs to know. */
struct SmoothingOptions
{
  /** In rounds (core/rounds/robust_smoothing.h), not as a chain of a normal filter and a point update. */
  bool robust = false;
  NormalSource normals = NormalSource::WPCA;
  HoughOptions hough;
  NormalFilterOptions filter;
  PointUpdateOptions update;
  /** Where noise.sigma, noise.spacing or sheet_distance is below 0 it is estimated; likewise an infinite
    * max_displacement, from sigma. */
  RobustSmoothingOptions rounds;
  /** rounds.noise.field is to be estimated too. */
  bool noise_varies = false;
  /** Neighbourhoods are to grow where they are too narrow to show the surface (core/noise/neighborhood_widening.h). */
  bool widen_neighborhoods = false;

  /** The same options for positions in another unit: see Positions::unit. What is to be estimated stays so. */
  SmoothingOptions
  inUnit (double unit) const;
};

/** \throw Error where an option is out of range, or normals are oriented that are to be estimated: their signs are
  * arbitrary */
void
check (const SmoothingOptions& options);

/** \param[in] k number of neighbours, the point itself included; 0 = by radius
  * \throw Error where nothing would be smoothed by so few: below 7 in rounds, which fit quadrics, else see
  * checkNeighborCount (NormalSource, int) */
void
checkNeighborCount (const SmoothingOptions& options, int k);

/** How far along the rows smooth looks: what becomes of a node depends on nodes that are so many hops off, and on the
  * rows of those that are fewer hops off. Not where neighbours are searched anew (update.search_interval): then it has
  * no bound.
  * \param[in] options without anything to estimate */
int
smoothingDepth (const SmoothingOptions& options);

/** How many of them are not NaN. */
std::size_t
countNormals (const Vectors& normals);

/** The first step of smooth: the normals that it begins with.
  * \param[in,out] surface its normals stay as they are for NormalSource::INPUT
  * \return how many nodes have one */
std::size_t
estimateFirstNormals (const NeighborGraph& graph,
                      const SmoothingOptions& options,
                      const Execution& execution,
                      MovingSurface& surface);

/** \throw Error for 0 */
void
requireNormals (std::size_t nodes_with_normal, NormalSource source);

/** The other steps of smooth. */
void
smoothByNormals (const NeighborGraph::ConstPtr& graph,
                 const SmoothingOptions& options,
                 const SearchAgain& search_again,
                 const Execution& execution,
                 MovingSurface& surface);

/** The whole method, Fig. 2 of Valdivia et al. 2013: estimate normals, filter them, move the points to fit them.
  * Or, for options.robust, all of it in rounds.
  * \param[in] options without anything to estimate
  * \param[in] search_again see updatePoints
  * \param[in,out] surface its normals are read only for NormalSource::INPUT; on return those that the points fit
  * \throw Error where no node has a normal */
void
smooth (const NeighborGraph::ConstPtr& graph,
        const SmoothingOptions& options,
        const SearchAgain& search_again,
        const Execution& execution,
        MovingSurface& surface);
} // namespace core
} // namespace pcl_normal_smoothing
