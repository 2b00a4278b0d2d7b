// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace pcl_normal_smoothing
{
namespace core
{
/** Residual variances of quadrics through the 8, 12 and 16 nearest of many points, in the square of the positions'
  * unit. */
using ResidualVariances = std::array<std::vector<float>, 3>;

/** Indices into ResidualVariances. */
constexpr std::size_t of_8 = 0, of_12 = 1, of_16 = 2;

/** Upper over lower quartile of the variances of the 12 nearest for even noise, as of chi-square with 6 degrees
  * of freedom. */
constexpr double quartile_ratio_of_12 = 2.27;

/** The same for the 16 nearest. */
constexpr double quartile_ratio_of_16 = 1.863;

/** The smallest neighbourhoods that show the noise, of_8 or of_12: if coordinates come in steps as large as the
  * noise (depth cameras), the eight nearest often lie exactly in one plane. */
std::size_t
smallestToTrust (const ResidualVariances& variances);

/** The neighbourhoods that show best how the noise varies, of_8 or of_12. Variances of the larger scatter less, and few
  * of these neighbourhoods lie along one line of a scanner's grid, where no residual is left. But they must not take
  * detail for noise. */
std::size_t
sizeForField (const ResidualVariances& variances);

/** Certainty, 0 to 1, that the noise is not along the normal but along rays, so that points show less of it where rays
  * meet the surface at a slant: then the lower quantiles are too low for a single sigma. Detail and edges make the
  * highest quantile too high instead, most of all for large neighbourhoods.
  * \param[in] variances at least one of each size */
double
certaintyOfSlant (const ResidualVariances& variances);

/** Sigma of the noise, from the variances without the effects of edges, curvature and other sheets; with slant, that of
  * the surfaces that face the rays.
  * \param[in] variances at least one of each size */
double
sigmaBy (const ResidualVariances& variances, double certainty_of_slant);

/** Sigma where density jumps from point to point, as among the vertices of coarse meshes: the eight nearest often lie
  * in a clump or along a line, so that many quadrics pass through all of them, and sigmaBy is too small.
  * \param[in] sigma without this correction \return \a sigma or more */
double
sigmaInClumps (const ResidualVariances& variances, double sigma);

/** Sigma for points along lines, where the eight nearest show only one line: see estimateLines. */
double
sigmaAcrossLines (const ResidualVariances& variances);
} // namespace core
} // namespace pcl_normal_smoothing
