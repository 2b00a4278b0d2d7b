// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../shapes.h"

#include <pcl_normal_smoothing/core/chain/normal_filter.h>
#include <pcl_normal_smoothing/core/chain/point_update.h>

// The stages of the method in double, written straight from the paper's equations: no speed, no cleverness, and no code
// shared with the library but its names of options.
namespace test_support
{
using Points = std::vector<Eigen::Vector3d>;
using Rows = std::vector<std::vector<std::size_t>>;

Points
inDouble (const Vectors& vectors);

/** The k nearest of every point, itself among them. */
Rows
nearestRows (const Points& points, std::size_t k);

struct OracleSurface
{
  Eigen::Vector3d normal;
  double variation;
};

/** Covariance about the centroid of all points of the row. */
OracleSurface
oraclePca (const Points& points, const std::vector<std::size_t>& row);

/** Eq. 1: weight 1 / distance, about the weighted centroid of the others. */
OracleSurface
oracleWpca (const Points& points, std::size_t i, const std::vector<std::size_t>& row);

/** Eqs. 2 to 7. */
Points
oracleFilter (const Points& points,
              const Rows& rows,
              Points normals,
              const pcl_normal_smoothing::core::NormalFilterOptions& options);

/** Eqs. 8 and 9, or the compensated form; no limit of the displacement, no new search. */
Points
oracleUpdate (Points points,
              const Rows& rows,
              const Points& normals,
              const pcl_normal_smoothing::core::PointUpdateOptions& options);

/** The mean normal of the fullest cell of \a bands bands of a sphere's half, every triple of the row voting once in
  * each of many turned accumulators; the winners averaged. */
Eigen::Vector3d
oracleHough (const Points& points, const std::vector<std::size_t>& row, int bands);
} // namespace test_support
