// SPDX-License-Identifier: BSD-3-Clause
//
// What a user may choose of the paper's steps, for the kernels too.
#pragma once

namespace pcl_normal_smoothing
{
/** The weight of a neighbour's normal, section II.B of Valdivia et al. 2013. */
enum class NormalWeight
{
  THRESHOLD, //!< eq. 3 (Sun et al. 2007)
  GAUSSIAN,  //!< eqs. 4 and 5 (Zheng et al. 2011)
  MIXED      //!< eqs. 6 and 7 (Wang et al. 2012)
};

/** The threshold of eq. 7: as printed, sqrt (sum x^2) / k, or the root mean square, sqrt (sum x^2 / k). */
enum class MixedThreshold
{
  PRINTED, //!< barely filters
  RMS      //!< filters as the paper's figures show
};

/** How points move to fit their normals. */
enum class UpdateRule
{
  /** Eq. 8 of Valdivia et al. 2013. Every term is n_j.(p_j - p_i): on a sphere of radius R, at the angle a, that is
    * R (1 - cos a) > 0 for all neighbours, so curved surfaces inflate with every iteration. */
  PAPER,
  /** Eq. 8 along the mean of both normals, m.(p_j - p_i) with m = (n_i + s n_j) / 2. A chord of a sphere is
    * perpendicular to the mean of the normals at its ends, so the term vanishes there, and nothing drifts. */
  COMPENSATED
};
} // namespace pcl_normal_smoothing
