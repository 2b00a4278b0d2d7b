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
  /** true: in rounds (core/rounds/robust_smoothing.h); false: by the paper's chain of normal filter and point update. */
  bool in_rounds = false;
  NormalSource normals = NormalSource::WPCA;
  HoughOptions hough;
  NormalFilterOptions filter;
  PointUpdateOptions update;
  /** If noise.sigma, noise.spacing or sheet_distance is below 0, it is estimated; an infinite max_displacement is
    * set from sigma. */
  RobustSmoothingOptions rounds;
  /** Whether rounds.noise.field is to be estimated too. */
  bool noise_varies = false;
  /** Whether neighbourhoods that are too narrow to show the surface are to grow
    * (core/noise/neighborhood_widening.h). */
  bool widen_neighborhoods = false;

  /** The same options for positions in another unit: see Positions::unit. Values to be estimated remain so. */
  SmoothingOptions
  inUnit (double unit) const;
};

/** \throw Error if an option is out of range, or if estimated normals are to count as oriented: their signs are
  * arbitrary */
void
check (const SmoothingOptions& options);

/** \param[in] k number of neighbours, the point itself included; 0: by radius
  * \throw Error if k is too small to smooth anything: below 7 in rounds, which fit quadrics; otherwise see
  * checkNeighborCount (NormalSource, int) */
void
checkNeighborCount (const SmoothingOptions& options, int k);

/** Depth of smooth in hops along the rows: the result of a node depends only on nodes up to that many hops away, and on
  * the rows of those fewer hops away. If neighbours are searched again (update.search_interval), there is no such
  * bound.
  * \param[in] options without anything to estimate */
int
smoothingDepth (const SmoothingOptions& options);

/** How many of them are not NaN. */
std::size_t
countNormals (const Vectors& normals);

/** The first step of smooth: the initial normals.
  * \param[in,out] surface its normals stay as they are for NormalSource::INPUT
  * \return number of nodes with a normal */
std::size_t
estimateFirstNormals (const NeighborGraph& graph,
                      const SmoothingOptions& options,
                      const Execution& execution,
                      MovingSurface& surface);

/** \throw Error if \a nodes_with_normal is 0 */
void
requireNormals (std::size_t nodes_with_normal, NormalSource source);

/** The remaining steps of smooth. */
void
smoothByNormals (const NeighborGraph::ConstPtr& graph,
                 const SmoothingOptions& options,
                 const SearchAgain& search_again,
                 const Execution& execution,
                 MovingSurface& surface);

/** The whole method, Fig. 2 of Valdivia et al. 2013: estimate normals, filter them, move the points to fit them; or,
  * for options.in_rounds, smoothing in rounds.
  * \param[in] options without anything to estimate
  * \param[in] search_again see updatePoints
  * \param[in,out] surface its normals are read only for NormalSource::INPUT; on return those that the points fit
  * \throw Error if no node has a normal */
void
smooth (const NeighborGraph::ConstPtr& graph,
        const SmoothingOptions& options,
        const SearchAgain& search_again,
        const Execution& execution,
        MovingSurface& surface);
} // namespace core
} // namespace pcl_normal_smoothing
