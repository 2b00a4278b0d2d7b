// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../kernels.h"
#include "../limits.h"
#include "../search/node_blocks.h"
#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

#include <cmath>

namespace pcl_normal_smoothing
{
namespace core
{
/** Number of neighbours that are tested. */
constexpr std::size_t sheet_row_length = max_row_length;

/** Number of neighbours on another sheet that show there is one. */
constexpr int min_other_neighbors = 3;

/** Rows this short hold only one or two points of another sheet, which are enough to spoil them. */
constexpr std::size_t short_row_length = 16;

/** \param[in] row_length the node included
  * \return how many neighbours on another sheet make a row change */
constexpr int
othersToChange (std::size_t row_length)
{
  return row_length > short_row_length ? min_other_neighbors : 1;
}

/** How clearly a neighbour must lie off the tangent plane to count as on another sheet; the slope allows for errors
  * of the normal. */
struct SheetEvidence
{
  float distances; // in sheet distances
  float slope;     // in distances to the neighbour
};

// A row is changed only on strong evidence. Once it is, weaker evidence suffices to drop a point: losing one too many
// does little harm.
constexpr SheetEvidence evidence_to_change = {1, .3f};
constexpr SheetEvidence evidence_to_drop = {.875f, .15f};

/** Tests whether two points lie on different sheets, at least a given distance apart. */
class SheetCriterion
{
public:
  /** \param[in] normals of the nodes that are tested
    * \param[in] oriented opposite normals suffice */
  SheetCriterion (const Positions& positions, const Vectors& normals, float distance, bool oriented)
  : positions_ (positions), normals_ (normals), sq_distance_ (distance * distance), oriented_ (oriented)
  {}

  bool
  areParallel (std::uint32_t i, std::uint32_t j) const
  {
    return std::abs (normals_[i].dot (normals_[j])) > min_cosine;
  }

  /** Height of j over the mean of both tangent planes, which touches a curved sheet. */
  float
  height (std::uint32_t i, std::uint32_t j) const
  {
    const Eigen::Vector3f &own = normals_[i], &normal = normals_[j];
    const Eigen::Vector3f way = positions_.difference (i, j);
    return .5f * (way.dot (own) + (own.dot (normal) < 0 ? -way.dot (normal) : way.dot (normal)));
  }

  /** Whether j may lie on the sheet of i or a parallel one that faces the same way. */
  bool
  areAlike (std::uint32_t i, std::uint32_t j) const
  {
    return areParallel (i, j) && !areOpposite (i, j);
  }

  /** \param[in] sheet height of the sheet of i over i */
  bool
  isOther (std::uint32_t i, std::uint32_t j, const SheetEvidence& evidence, float sheet = 0) const
  {
    if (areOpposite (i, j))
      return true;
    const float of_pair = height (i, j) - sheet;
    return areParallel (i, j) &&
           of_pair * of_pair > evidence.distances * evidence.distances * sq_distance_ +
                                   evidence.slope * evidence.slope * squaredLength (positions_.difference (i, j));
  }

  /** isOther for the neighbours of many nodes at once. \param[out] others how many of each node's are */
  OtherSheetCount
  ofRows (const SheetEvidence& evidence, Numbers& others) const
  {
    return {nodeArrays (positions_, normals_),
            evidence.distances * evidence.distances * sq_distance_,
            evidence.slope * evidence.slope,
            min_cosine,
            oriented_,
            others.data ()};
  }

private:
  bool
  areOpposite (std::uint32_t i, std::uint32_t j) const
  {
    return oriented_ && normals_[i].dot (normals_[j]) < 0;
  }

  // Only parallel sheets count, not neighbours across an edge.
  static constexpr float min_cosine = .7f;

  const Positions& positions_;
  const Vectors& normals_;
  float sq_distance_;
  bool oriented_;
};
} // namespace core
} // namespace pcl_normal_smoothing
