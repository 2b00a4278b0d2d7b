// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/chain/hough.h>
#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

namespace pcl_normal_smoothing
{
/** The source of the normals, section II.A of Valdivia et al. 2013. */
enum class NormalSource
{
  PCA,
  WPCA,
  HOUGH,
  INPUT //!< the input's own
};

namespace core
{
/** Maps a neighbourhood to its surface. Called from many threads. */
using SurfaceEstimator = std::function<LocalSurface (const Neighborhood&)>;

/** \param[in] k number of neighbours, the point itself included; 0: by radius
  * \throw Error if no neighbourhood of k points can have a normal: below 4 for WPCA, below 3 for PCA and HOUGH */
void
checkNeighborCount (NormalSource source, int k);

/** \throw Error for NormalSource::INPUT, and if a Hough option is out of range */
SurfaceEstimator
makeEstimator (NormalSource source, const HoughOptions& hough);

/** The surfaces of all nodes. */
std::vector<LocalSurface>
estimateSurfaces (const NeighborGraph& graph,
                  const Positions& nodes,
                  const SurfaceEstimator& estimator,
                  const Execution& execution);

/** The normals of all nodes. */
Vectors
estimateNormals (const NeighborGraph& graph,
                 const Positions& nodes,
                 const SurfaceEstimator& estimator,
                 const Execution& execution);

/** Replaces \a neighbors by the numbers of the neighbours of query point \a i, in any order. Called from many
  * threads. */
using QuerySearch = std::function<void (std::size_t i, std::vector<std::uint32_t>& neighbors)>;

/** The surfaces at points that need not be among those that sample it; query.k counts all points found.
  * \param[in] surface points that are not finite are left out
  * \param[in] queries if one is not finite, its result is invalid */
std::vector<LocalSurface>
querySurfaces (const Positions& surface,
               const Positions& queries,
               const NeighborQuery& query,
               const SurfaceEstimator& estimator,
               const Execution& execution);

/** As above, with the results of any search, which is called for finite points only. */
std::vector<LocalSurface>
querySurfaces (const Positions& surface,
               const Positions& queries,
               const QuerySearch& search,
               const SurfaceEstimator& estimator,
               const Execution& execution);
} // namespace core
} // namespace pcl_normal_smoothing
