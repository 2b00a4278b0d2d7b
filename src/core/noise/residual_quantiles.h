// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace pcl_normal_smoothing
{
namespace core
{
/** What quadrics through the 8, 12 and 16 nearest leave about many points, each as a variance in the square of the
  * positions' unit. */
using ResidualVariances = std::array<std::vector<float>, 3>;

/** Their places in ResidualVariances. */
constexpr std::size_t of_8 = 0, of_12 = 1, of_16 = 2;

/** The upper quartile of the variances of the 12 nearest over the lower one, where there is one noise: that of
  * chi-square by 6 degrees of freedom. */
constexpr double quartile_ratio_of_12 = 2.27;

/** The same of sixteen points. */
constexpr double quartile_ratio_of_16 = 1.863;

/** The smallest neighbourhoods that tell of the noise, of_8 or of_12: coordinates in steps as large as the noise (depth
  * cameras) often put the eight nearest in one plane exactly. */
std::size_t
smallestToTrust (const ResidualVariances& variances);

/** How sure it is, 0 to 1, that the noise goes not along the normal but along rays, and points show less of it where
  * these meet the surface at a slant: then the lower quantiles are too low for one sigma. Detail and edges make the
  * highest too high instead, and that of large neighbourhoods most.
  * \param[in] variances at least one of each size */
double
certaintyOfSlant (const ResidualVariances& variances);

/** Sigma of the noise: what is left of the variances without edges, curvature and other sheets; with slant, that of the
  * surfaces that face the rays.
  * \param[in] variances at least one of each size */
double
sigmaBy (const ResidualVariances& variances, double certainty_of_slant);

/** The same where density jumps from point to point, as that of the vertices of coarse meshes: the eight nearest often
  * lie in a clump or along a line, where many a quadric goes through all of them, so that sigmaBy is too small.
  * \param[in] sigma as it is without \return \a sigma or more */
double
sigmaInClumps (const ResidualVariances& variances, double sigma);

/** The same where points lie along lines, of which eight nearest show only one: see estimateLines. */
double
sigmaAcrossLines (const ResidualVariances& variances);
} // namespace core
} // namespace pcl_normal_smoothing
