// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../shapes.h"

#include <pcl_normal_smoothing/core/chain/normal_filter.h>
#include <pcl_normal_smoothing/core/chain/point_update.h>

// The stages of the method in double, written directly from the paper's equations: slow and simple, and sharing no code
// with the library except the names of its options.
namespace test_support
{
using Points = std::vector<Eigen::Vector3d>;
using Rows = std::vector<std::vector<std::size_t>>;

Points
inDouble (const Vectors& vectors);

/** The k nearest points of every point, itself included. */
Rows
nearestRows (const Points& points, std::size_t k);

struct OracleSurface
{
  Eigen::Vector3d normal;
  double variation;
};

/** From the covariance of all points of the row about their centroid. */
OracleSurface
oraclePca (const Points& points, const std::vector<std::size_t>& row);

/** Eq. 1: weights 1 / distance, about the weighted centroid of the other points. */
OracleSurface
oracleWpca (const Points& points, std::size_t i, const std::vector<std::size_t>& row);

/** Eqs. 2 to 7. */
Points
oracleFilter (const Points& points,
              const Rows& rows,
              Points normals,
              const pcl_normal_smoothing::core::NormalFilterOptions& options);

/** Eqs. 8 and 9, or the compensated form; without displacement limit and without searching neighbours again. */
Points
oracleUpdate (Points points,
              const Rows& rows,
              const Points& normals,
              const pcl_normal_smoothing::core::PointUpdateOptions& options);

/** Every triple of the row votes once in each of many rotated accumulators, which divide a half sphere into \a bands
  * bands of cells. Returns the average of the mean normals of their fullest cells. */
Eigen::Vector3d
oracleHough (const Points& points, const std::vector<std::size_t>& row, int bands);
} // namespace test_support
