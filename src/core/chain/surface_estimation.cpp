// SPDX-License-Identifier: BSD-3-Clause
#include "../search/kd_tree.h"
#include <pcl_normal_smoothing/core/chain/surface_estimation.h>
#include <pcl_normal_smoothing/core/error.h>

#include <algorithm>
#include <string>

namespace pcl_normal_smoothing
{
namespace core
{
void
checkNeighborCount (NormalSource source, int k)
{
  const bool without_itself = source == NormalSource::WPCA;
  const int least = without_itself ? 4 : source == NormalSource::INPUT ? 0 : 3;
  if (k > 0 && k < least)
    throw Error ("k is " + std::to_string (k) + ", the point itself included, but a normal needs " +
                 (without_itself ? "three others in WPCA" : "three points") + ": give k of at least " +
                 std::to_string (least));
}

SurfaceEstimator
makeEstimator (NormalSource source, const HoughOptions& hough)
{
  switch (source) {
  case NormalSource::PCA:
    return pcaSurface;
  case NormalSource::WPCA:
    return wpcaSurface;
  case NormalSource::HOUGH: {
    const HoughEstimator estimator (hough);
    return [estimator] (const Neighborhood& neighborhood) { return estimator.estimate (neighborhood); };
  }
  case NormalSource::INPUT:
    break;
  }
  throw Error ("the input's own normals are not estimated");
}

namespace
{
/** Calls \a use (node, its surface) for all nodes, in parallel. */
template <typename Use>
void
forEachSurface (const NeighborGraph& graph,
                const Positions& nodes,
                const SurfaceEstimator& estimator,
                const Execution& execution,
                const Use& use)
{
  parallelFor (graph.size (), execution, [&] (std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      use (i, estimator ({nodes, nodes.base[i], nodes.offset[i], graph.row (i)}));
    }
  });
}
} // namespace

std::vector<LocalSurface>
estimateSurfaces (const NeighborGraph& graph,
                  const Positions& nodes,
                  const SurfaceEstimator& estimator,
                  const Execution& execution)
{
  std::vector<LocalSurface> surfaces (graph.size ());
  forEachSurface (graph, nodes, estimator, execution,
                  [&] (std::size_t i, const LocalSurface& surface) { surfaces[i] = surface; });
  return surfaces;
}

Vectors
estimateNormals (const NeighborGraph& graph,
                 const Positions& nodes,
                 const SurfaceEstimator& estimator,
                 const Execution& execution)
{
  Vectors normals (graph.size ());
  forEachSurface (graph, nodes, estimator, execution,
                  [&] (std::size_t i, const LocalSurface& surface) { normals[i] = surface.normal; });
  return normals;
}

std::vector<LocalSurface>
querySurfaces (const Positions& surface,
               const Positions& queries,
               const NeighborQuery& query,
               const SurfaceEstimator& estimator,
               const Execution& execution)
{
  std::vector<LocalSurface> result (queries.size (), LocalSurface::invalid ());
  const Elements finite = finiteElements (surface, execution.silent ());
  if (finite.empty ())
    return result;
  const Positions points = gather (surface, finite, execution.silent ());
  const KdTree tree (points, finite, execution);
  parallelFor (queries.size (), execution, [&] (std::size_t begin, std::size_t end) {
    KdTree::Scratch scratch;
    std::vector<std::uint32_t> row;
    for (std::size_t i = begin; i < end; ++i) {
      if (!queries.base[i].allFinite ())
        continue;
      row.clear ();
      for (const Neighbor& neighbor : tree.search (queries.base[i], queries.offset[i], query, scratch))
        row.push_back (tree.order ()[neighbor.slot]);
      result[i] = estimator ({points, queries.base[i], queries.offset[i], Row (row.data (), row.size (), 1)});
    }
  });
  return result;
}

std::vector<LocalSurface>
querySurfaces (const Positions& surface,
               const Positions& queries,
               const QuerySearch& search,
               const SurfaceEstimator& estimator,
               const Execution& execution)
{
  std::vector<LocalSurface> result (queries.size (), LocalSurface::invalid ());
  parallelFor (queries.size (), execution, [&] (std::size_t begin, std::size_t end) {
    std::vector<std::uint32_t> row;
    std::vector<Neighbor> found;
    for (std::size_t i = begin; i < end; ++i) {
      if (!queries.base[i].allFinite ())
        continue;
      search (i, row);
      found.clear ();
      for (const std::uint32_t j : row) {
        if (j >= surface.size ())
          throw Error ("the search object returned point " + std::to_string (j) +
                       ", which the search surface does not have: let it search the same cloud");
        const Neighborhood one (surface, queries.base[i], queries.offset[i], Row (&j, 1, 1));
        found.push_back ({squaredLength (one[0]), j, j});
      }
      std::sort (found.begin (), found.end ());
      std::transform (found.begin (), found.end (), row.begin (), [] (const Neighbor& n) { return n.slot; });
      result[i] = estimator ({surface, queries.base[i], queries.offset[i], Row (row.data (), row.size (), 1)});
    }
  });
  return result;
}
} // namespace core
} // namespace pcl_normal_smoothing
