// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/normal_filter.h>
#include <pcl_normal_smoothing/core/point_update.h>
#include <pcl_normal_smoothing/core/robust_smoothing.h>
#include <pcl_normal_smoothing/core/sheet_estimate.h>
#include <pcl_normal_smoothing/core/sheet_separation.h>
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
  /** rounds.noise.field is to be estimated too. */
  bool noise_varies = false;

  /** The same options for positions in another unit: see Positions::unit. What is to be estimated stays so. */
  SmoothingOptions
  inUnit (double unit) const;
};

/** \throw Error where an option is out of range, or normals are oriented that are to be estimated: their signs are arbitrary */
void
check (const SmoothingOptions& options);

/** Lets the data tell what smoothing in rounds has to know: which neighbours lie on another sheet, the noise of the cloud,
  * and what follows from it. Nothing changes for the paper's chain.
  * \param[in] normals read only for NormalSource::INPUT
  * \param[in,out] graph on return without neighbours on other sheets
  * \param[in,out] options that pass check; on return without anything to estimate; given again, they give the same graph */
void
prepareSmoothing (const Positions& positions,
                  const Vectors& normals,
                  const Execution& execution,
                  NeighborGraph::ConstPtr& graph,
                  SmoothingOptions& options);

/** The parts of prepareSmoothing, for a cloud that is seen in tiles: what is estimated is estimated for all of it. */
struct SmoothingPreparation
{
  /** The noise has to be estimated, with the graph as it was searched. */
  static bool
  needsNoise (const SmoothingOptions& options);

  /** The distance by which sheets are looked for, with the graph as it was searched. \return infinity where they are not to be */
  static float
  sheetTestDistance (const NoiseEstimate& noise, const SmoothingOptions& options);

  /** Sets the distance of the sheets where it is to be estimated.
    * \param[in] noise, sheets the estimates with the graph as it was searched
    * \return whether the sheets are to be separated */
  static bool
  setSheetDistance (const NoiseEstimate& noise, const SheetEstimate& sheets, SmoothingOptions& options);

  /** \param[in] normals as for prepareSmoothing; kept while the result is used */
  static SheetSeparationOptions
  separation (const SmoothingOptions& options, const Vectors& normals);

  /** The estimate where the sheets were separated.
    * \param[in] mixed, separated the estimates before and after; sigma 0: too little is left to tell */
  static NoiseEstimate
  chooseNoise (const NoiseEstimate& mixed, const NoiseEstimate& separated, const SheetEstimate& sheets);

  /** Whether what was told apart is no sheets but the layers of coordinates in steps, as depth cameras give them: then all
    * lies on one sheet.
    * \param[in] mixed, separated, sheets as for chooseNoise */
  static bool
  areLayers (const NoiseEstimate& mixed, const NoiseEstimate& separated, const SheetEstimate& sheets);

  /** Sets whatever else is to be estimated. */
  static void
  setNoise (const NoiseEstimate& noise, SmoothingOptions& options);
};

/** How far along the rows smooth looks: what becomes of a node depends on nodes that are so many hops off, and on the rows of those
  * that are fewer hops off. Not where neighbours are searched anew (update.search_interval): then it has no bound.
  * \param[in] options without anything to estimate */
int
smoothingDepth (const SmoothingOptions& options);

/** The first step of smooth: the normals that it begins with.
  * \param[out] normals left as they are for NormalSource::INPUT
  * \return how many nodes have one */
std::size_t
estimateFirstNormals (const NeighborGraph& graph,
                      const SmoothingOptions& options,
                      const Execution& execution,
                      const Positions& positions,
                      Vectors& normals);

/** \throw Error for 0 */
void
requireNormals (std::size_t nodes_with_normal);

/** The other steps of smooth. */
void
smoothByNormals (const NeighborGraph::ConstPtr& graph,
                 const SmoothingOptions& options,
                 const Research& research,
                 const Execution& execution,
                 Positions& positions,
                 Vectors& normals);

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
