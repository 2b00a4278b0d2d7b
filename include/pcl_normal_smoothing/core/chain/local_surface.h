// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/positions.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** The normal and surface variation of a neighbourhood. */
struct LocalSurface
{
  /** Unit length, arbitrary sign; NaN if fewer than 3 points count or they lie on a line. WPCA does not count the
    * point itself. */
  Eigen::Vector3f normal;
  /** Surface variation, l0 / (l0 + l1 + l2) with l0 the smallest eigenvalue of the covariance (Pauly et al. 2002): 0 to
    * 1/3; NaN with the normal. */
  float variation;

  static LocalSurface
  invalid ();
};

/** PCA (Hoppe et al. 1992): the covariance about the centroid of the neighbourhood, the point itself included. */
LocalSurface
pcaSurface (const Neighborhood& neighborhood);

/** WPCA, eq. 1 of Valdivia et al. 2013: weight 1 / |p_j - p_i| over the other points, about their weighted centroid.
  * Points at distance zero have no direction and are skipped, so three others are needed. */
LocalSurface
wpcaSurface (const Neighborhood& neighborhood);
} // namespace core
} // namespace pcl_normal_smoothing
