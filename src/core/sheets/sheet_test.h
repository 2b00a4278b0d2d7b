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
/** How many neighbours are asked whether they lie on another sheet. */
constexpr std::size_t sheet_row_length = max_row_length;

/** So many of them tell that there is one. */
constexpr int min_other_neighbors = 3;

/** Rows of so few neighbours hold but one or two of another sheet, though these spoil them. */
constexpr std::size_t short_row_length = 16;

/** \param[in] row_length the node counted
  * \return how many neighbours on another sheet change a row */
constexpr int
othersToChange (std::size_t row_length)
{
  return row_length > short_row_length ? min_other_neighbors : 1;
}

/** How sure it must be that a neighbour lies on another sheet: normals are wrong by some slope. */
struct SheetEvidence
{
  float distances; // of the sheet distance
  float slope;     // of the way to the neighbour
};

// A row changes only where there is no doubt; then it had better lose a point too much.
constexpr SheetEvidence evidence_to_change = {1, .3f};
constexpr SheetEvidence evidence_to_drop = {.875f, .15f};

/** Whether two points lie on sheets that are so far apart. */
class SheetTest
{
public:
  /** \param[in] normals of the nodes that are asked for
    * \param[in] oriented opposite normals are enough */
  SheetTest (const Positions& positions, const Vectors& normals, float distance, bool oriented)
  : positions_ (positions), normals_ (normals), sq_distance_ (distance * distance), oriented_ (oriented)
  {}

  bool
  areParallel (std::uint32_t i, std::uint32_t j) const
  {
    return std::abs (normals_[i].dot (normals_[j])) > min_cosine;
  }

  /** How far j lies from the mean of both tangent planes, which a curved sheet touches. */
  float
  height (std::uint32_t i, std::uint32_t j) const
  {
    const Eigen::Vector3f &own = normals_[i], &normal = normals_[j];
    const Eigen::Vector3f way = positions_.difference (i, j);
    return .5f * (way.dot (own) + (own.dot (normal) < 0 ? -way.dot (normal) : way.dot (normal)));
  }

  /** Where j may lie on the sheet of i or on a parallel one, and not on another side of it. */
  bool
  areAlike (std::uint32_t i, std::uint32_t j) const
  {
    return areParallel (i, j) && !areOpposite (i, j);
  }

  /** \param[in] sheet how high the sheet of i is above it */
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

  /** isOther of the neighbours of many nodes at once. \param[out] others how many of each are */
  OtherSheetTest
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

  // Sheets are parallel; a neighbour across an edge is none of them.
  static constexpr float min_cosine = .7f;

  const Positions& positions_;
  const Vectors& normals_;
  float sq_distance_;
  bool oriented_;
};
} // namespace core
} // namespace pcl_normal_smoothing
